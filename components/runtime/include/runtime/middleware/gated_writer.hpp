// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "runtime/bus.hpp"
#include "runtime/middleware/traffic_rules.hpp"

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

  GatedWriter(std::string topic, const TrafficRule& rule, std::unique_ptr<LinkWriter> writer,
              Freshness freshness);

  Status write(const std::shared_ptr<const void>& message);
  /// Topics that are always active ignore it. Opening sends what `latest` has kept, unless its
  /// lifespan is over: then it counts as dropped.
  void set_open(bool open);
  [[nodiscard]] TopicTraffic traffic() const;

 private:
  Status keep(const std::shared_ptr<const void>& message);
  void send_kept();

  const WhilePoor while_poor_;
  const std::unique_ptr<LinkWriter> writer_;
  mutable std::mutex mutex_;
  bool open_ = true;
  const Freshness freshness_;
  std::shared_ptr<const void> kept_;
  Time kept_at_{};
  TopicTraffic traffic_;
};

}  // namespace tocsin
