// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "foundation/time.hpp"
#include "radio_channel/access_category.hpp"

namespace tocsin::radio {

using FrameId = std::uint64_t;

/// One unit of work for the MAC.
struct AirFrame {
  FrameId id;
  int bytes;          ///< of the IP packet
  bool acknowledged;  ///< false: group-addressed from the access point, one try, 6 Mbit/s
  AccessCategory category = AccessCategory::best_effort;
  std::size_t vehicle = 0;  ///< that sends it, or to which the access point does
  Time queued = {};         ///< since when it waits
  int attempt = 0;          ///< transmissions so far
  bool received = false;    ///< the receiver has it (its acknowledgement may have been lost)
};

/// What waits for one contention: a queue for each receiver, which take turns by airtime, as in
/// Linux's mac80211 (deficit round robin; Hoiland-Jorgensen et al., "Ending the Anomaly", USENIX
/// ATC 2017). So a receiver that takes many attempts costs the others no more than its share.
class FrameQueue {
 public:
  explicit FrameQueue(std::size_t receivers) : queues_(receivers), credits_(receivers) {}

  [[nodiscard]] bool empty() const { return frames_ == 0; }
  [[nodiscard]] std::size_t size(std::size_t receiver) const { return queues_[receiver].size(); }
  void push_back(std::size_t receiver, const AirFrame& frame) {
    queues_[receiver].push_back(frame);
    if (frames_++ == 0) current_ = receiver;
  }
  /// Whose turn it is, until pop_front(). There must be one.
  [[nodiscard]] AirFrame& front() { return queues_[current_].front(); }
  [[nodiscard]] const AirFrame& front() const { return queues_[current_].front(); }
  /// Its attempt has taken so long.
  void spend(Duration airtime) { credits_[current_] -= airtime; }
  void pop_front();

 private:
  std::vector<std::deque<AirFrame>> queues_;
  std::vector<Duration> credits_;
  std::size_t frames_ = 0;
  std::size_t current_ = 0;
};

}  // namespace tocsin::radio
