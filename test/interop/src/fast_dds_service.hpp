// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/fast_dds/names.hpp"

namespace tocsin::interop {

/// One half of a service on Fast DDS with the default settings of its library, as rmw_fastrtps
/// makes it: it writes one topic and reads the other, as bytes.
class FastDdsService {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using Identity = eprosima::fastdds::rtps::SampleIdentity;
  struct Half {
    std::string topic;
    std::string type;
  };
  struct Taken {
    Bytes bytes;
    Identity identity;  ///< its own
    Identity related;
  };
  FastDdsService(int domain, const Half& written, const Half& read);
  ~FastDdsService();
  FastDdsService(const FastDdsService&) = delete;
  FastDdsService& operator=(const FastDdsService&) = delete;

  /// Whether somebody reads what it writes, and writes what it reads.
  [[nodiscard]] bool is_connected() const;
  /// The number of the sample.
  std::int64_t write(const Bytes& bytes, const Identity& related);
  [[nodiscard]] std::optional<Taken> take();
  [[nodiscard]] eprosima::fastdds::rtps::GUID_t reader_guid() const { return reader_->guid(); }

 private:
  eprosima::fastdds::dds::Topic* topic(const Half& half);
  eprosima::fastdds::dds::DomainParticipant* participant_;
  eprosima::fastdds::dds::DataReader* reader_ = nullptr;
  eprosima::fastdds::dds::DataWriter* writer_ = nullptr;
};

}  // namespace tocsin::interop
