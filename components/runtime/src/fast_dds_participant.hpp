// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {

/// Where a participant lives and whom it looks for. UDP and unicast only: nothing is multicast,
/// no shared-memory file is left behind, and traffic stays on the interface of `address`.
struct ParticipantOptions {
  std::string name;
  int domain = 0;
  std::string address;             ///< IPv4 of the only interface that is used
  std::vector<std::string> peers;  ///< IPv4 addresses that are asked for participants
  int peer_participants = 4;       ///< [1, 100] participant ids that are asked at each of them
  bool radio = false;              ///< small RTPS messages, asynchronous writers, patient lease
};

/// A Fast DDS participant with one publisher and one subscriber. Deletes all that it made.
class FastDdsParticipant {
 public:
  /// Throws EnvironmentError when Fast DDS cannot create it.
  explicit FastDdsParticipant(ParticipantOptions options);
  ~FastDdsParticipant();
  FastDdsParticipant(const FastDdsParticipant&) = delete;
  FastDdsParticipant& operator=(const FastDdsParticipant&) = delete;

  /// `topic` is the DDS name, with `rt/`. The listener must outlive the endpoint.
  eprosima::fastdds::dds::DataWriter* create_writer(
      const std::string& topic, const TypeInfo& type, const QosProfile& qos,
      eprosima::fastdds::dds::DataWriterListener& listener);
  eprosima::fastdds::dds::DataReader* create_reader(
      const std::string& topic, const TypeInfo& type, const QosProfile& qos,
      eprosima::fastdds::dds::DataReaderListener& listener);
  void remove(eprosima::fastdds::dds::DataWriter* writer);
  void remove(eprosima::fastdds::dds::DataReader* reader);
  /// Whether a writer is one of this participant's own.
  [[nodiscard]] bool owns(const eprosima::fastrtps::rtps::GUID_t& writer) const;

 private:
  eprosima::fastdds::dds::Topic* topic(const std::string& name, const TypeInfo& type);
  ParticipantOptions options_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
};

}  // namespace tocsin
