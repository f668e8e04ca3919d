// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::bag_tool {

/// Samples that wait for the thread that writes them to the disk, in the order of their arrival.
class RecordQueue {
 public:
  struct Item {
    std::size_t topic;
    RawSample sample;
  };

  /// `most_bytes` [byte]: more than that does not wait, apart from one sample.
  explicit RecordQueue(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Any thread. A sample for which there is no room is dropped and counted.
  void push(std::size_t topic, RawSample&& sample);
  /// All that waits; waits for it at most `patience`.
  [[nodiscard]] std::vector<Item> take(Duration patience);
  /// Samples that were dropped. Any thread.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::vector<Item> items_;
  std::size_t bytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace tocsin::bag_tool
