// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bag/bag_writer.hpp"
#include "mcap/writer.hpp"

namespace tocsin::bag {

/// One MCAP file of a bag with its topics.
class BagWriter::File {
 public:
  /// Throws ConfigError when it cannot be made.
  File(const std::string& path, mcap::Compression compression);

  void add(const Topic& topic);
  mcap::Kept write(std::size_t topic, const Message& message);
  [[nodiscard]] mcap::Writer& writer() { return writer_; }
  [[nodiscard]] const mcap::Writer& writer() const { return writer_; }
  /// Messages of a topic that are in the file.
  [[nodiscard]] std::uint64_t count(std::size_t topic) const;
  /// [ns] log time of its first message, which may still be in memory; 0: there is none.
  [[nodiscard]] std::int64_t start_ns() const { return start_ns_; }

 private:
  [[nodiscard]] std::uint16_t schema_of(const Topic& topic);
  /// Each writer of a topic has one; a file has room for 65,535.
  [[nodiscard]] std::uint16_t channel_of(std::size_t topic, std::uint64_t writer);

  mcap::FileSink sink_;
  mcap::Writer writer_;
  std::map<std::string, std::uint16_t> schemas_;
  std::vector<mcap::Channel> topics_;  ///< the channel of each that is of no writer
  std::map<std::pair<std::size_t, std::uint64_t>, std::uint16_t> of_writers_;
  std::int64_t start_ns_ = 0;
};

}  // namespace tocsin::bag
