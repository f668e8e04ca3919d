// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "link_router/delivery_log.hpp"
#include "link_router/link_queue.hpp"
#include "link_router/link_state_values.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// What became of all samples, by class and by stream, and the fates of those of stored streams.
/// Pure.
class LinkCounters {
 public:
  using Classes = std::array<ClassCounts, traffic_classes.size()>;

  void on_offered(StreamId stream, TrafficClass traffic_class);
  void on_first_sent(const SentSample& sent);
  /// It takes so many bytes on the wire.
  void on_repair(TrafficClass traffic_class, std::size_t bytes) {
    ++of(traffic_class).repairs;
    of(traffic_class).repair_bytes += bytes;
  }
  void on_dropped(const Waiting& waiting, const StreamRule& rule, DropReason reason);
  /// One-way delay of one that was received, over the least seen lately.
  void on_delay(TrafficClass traffic_class, Duration delay) { of(traffic_class).delay = delay; }
  /// Its fate is decided; see SentSample::missing and ::received.
  void conclude(SentSample& sent);
  /// One that was given up too early has been received by every peer that wants it.
  void revoke_loss(SentSample& sent);
  /// Its stream is removed.
  void end(SentSample& sent);
  void forget_stream(StreamId stream) { streams_.erase(stream); }

  [[nodiscard]] const Classes& classes() const { return classes_; }
  /// Zeroes when there is no such stream.
  [[nodiscard]] StreamCounts of_stream(StreamId stream) const;
  /// What became of samples of stored streams since the last call.
  [[nodiscard]] std::vector<StoredFate> take_fates() { return std::exchange(fates_, {}); }

 private:
  [[nodiscard]] ClassCounts& of(TrafficClass traffic_class) {
    return classes_[index_of(traffic_class)];
  }
  void on_delivered(SentSample& sent);
  void note_fate(const SentSample& sent, LiveFate fate);
  Classes classes_;
  std::map<StreamId, StreamCounts> streams_;
  std::vector<StoredFate> fates_;
};

}  // namespace tocsin::router
