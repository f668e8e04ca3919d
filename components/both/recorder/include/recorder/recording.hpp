// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "recorder/topic_choice.hpp"
#include "runtime/bus.hpp"

namespace tocsin {

/// A recording on a disk, in whatever format: the recorder chooses what is recorded, this how.
/// Used by one thread. After its constructor nothing throws; what a full disk takes is counted.
class Recording {
 public:
  virtual ~Recording() = default;
  /// The number by which `write` knows the topic. Throws ConfigError when the format cannot hold
  /// it. The topic must outlive the recording.
  [[nodiscard]] virtual std::size_t add(const ChosenTopic& topic) = 0;
  /// A sample of a topic. It may reach the disk later.
  virtual void write(std::size_t topic, const Sample& sample) = 0;
  /// Brings all that waits to the disk.
  virtual void flush() = 0;
  /// Rows, or messages, that did not reach the disk since the beginning.
  [[nodiscard]] virtual std::uint64_t lost() const = 0;
};

}  // namespace tocsin
