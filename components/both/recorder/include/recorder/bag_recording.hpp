// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bag/bag_writer.hpp"
#include "recorder/topic_choice.hpp"
#include "runtime/bus.hpp"

namespace tocsin {

/// What recording leaves to others: a share of the disk, but no more than so many bytes.
struct KeptFree {
  double share = 0;  ///< [range 0,1]
  std::uint64_t most_bytes = 1'000'000'000;
};

/// A bag with the messages as they are on the wire: `bag` in the folder, or `bag_2`, ... for a
/// recorder that was started again, since a bag belongs to one process. On a full disk it begins
/// when there is room. It writes nothing while less than `kept_free` is free. One thread. After its
/// constructor nothing throws; what a full disk takes is counted.
class BagRecording {
 public:
  /// Throws ConfigError naming the folder when it cannot be made.
  BagRecording(const std::string& directory, mcap::Compression compression,
               const KeptFree& kept_free = {});

  /// The number by which `write` knows the topic, which must outlive the recording.
  [[nodiscard]] std::size_t add(const ChosenTopic& topic);
  /// A sample of a topic. It may reach the disk later.
  void write(std::size_t topic, const Sample& sample);
  /// Brings all that waits to the disk.
  void flush();
  /// Messages that did not reach the disk since the beginning.
  [[nodiscard]] std::uint64_t lost() const;

 private:
  /// Throws ConfigError.
  void begin();
  [[nodiscard]] bool has_room() const;

  const std::string directory_;
  const KeptFree kept_free_;
  const bag::BagOptions options_;
  std::vector<bag::Topic> topics_;
  std::vector<const TypeInfo*> types_;      ///< by topic
  std::unique_ptr<bag::BagWriter> writer_;  ///< null: there was no room for it yet
  bool holds_back_ = false;                 ///< there was no room at the last flush
  std::uint64_t left_out_ = 0;              ///< messages that came while either was so
  std::vector<std::uint8_t> bytes_;         ///< of the message that is written
};

}  // namespace tocsin
