// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "runtime/bus.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "runtime/middleware/turn_lock.hpp"

namespace tocsin {

/// What the gate needs of a middleware writer.
class LinkWriter {
 public:
  virtual ~LinkWriter() = default;
  /// Bytes of the encoded sample; 0 when the middleware refused it.
  virtual std::size_t send(const void* message) = 0;
  /// Forgets every sample, so that nothing more is sent for them, no heartbeat either.
  virtual void silence() = 0;
};

/// The gate in front of one link writer. Thread-safe: write and set_open exclude each other, so
/// that nothing slips out after set_open(false) has returned.
class GatedWriter {
 public:
  /// How long a kept sample may wait. Without a clock: for ever.
  struct Freshness {
    std::function<Time()> now;
    Duration lifespan{0};
  };

  /// `writer` is null while the link is not up; until `connect` this is a closed gate, for topics
  /// that are always active, too: those keep their newest sample.
  GatedWriter(std::string topic, const TrafficRule& rule, std::unique_ptr<LinkWriter> writer,
              Freshness freshness);

  /// Here, because this is in the way of every sample.
  Status write(const std::shared_ptr<const void>& message) {
    const std::lock_guard<TurnLock> lock(turn_);
    ++traffic_.written;
    return sends_.load(std::memory_order_relaxed) ? send(message.get()) : keep(message);
  }
  /// Topics that are always active ignore it. Opening sends what `latest` has kept, unless its
  /// lifespan is over: then it counts as dropped.
  void set_open(bool open);
  void connect(std::unique_ptr<LinkWriter> writer);
  [[nodiscard]] TopicTraffic traffic() const;

 private:
  Status send(const void* message) {
    const std::size_t bytes = writer_->send(message);
    if (bytes == 0) return Status::failed;
    ++traffic_.sent;
    traffic_.sent_bytes += bytes;
    return Status::ok;
  }
  Status keep(const std::shared_ptr<const void>& message);
  void send_kept();
  void settle();

  mutable TurnLock turn_;
  std::atomic<bool> sends_;  // changed with the turn, or to false
  TopicTraffic traffic_;
  std::unique_ptr<LinkWriter> writer_;
  const WhilePoor while_poor_;
  bool open_ = true;
  bool silent_ = true;
  const Freshness freshness_;
  std::shared_ptr<const void> kept_;
  Time kept_at_{};
};

}  // namespace tocsin
