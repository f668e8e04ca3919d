// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "runtime/bus.hpp"
#include "runtime/detail/instance_table.hpp"
#include "runtime/middleware/qos_policies.hpp"
#include "runtime/middleware/thinning.hpp"

namespace tocsin {

/// Hands the samples of one topic to its receivers in this process. Thread-safe; the order in
/// which one writer delivers is the order in which every receiver gets it.
///
/// It keeps what the topic's profile promises wherever a sample came from: the last `depth`
/// samples of each writer and instance for late receivers of a transient_local topic, lifespan,
/// minimum separation, deadline.
class TopicExchange {
 public:
  explicit TopicExchange(const QosProfile& qos);
  /// `keeps_last`: a receiver that attaches later gets the last sample of each writer at once.
  explicit TopicExchange(bool keeps_last);

  /// `now`: kept samples that have outlived their lifespan are not delivered.
  void attach(Receiver& receiver, Time now = Time{});
  /// Waits until `receiver` is not being called any more.
  void detach(Receiver& receiver);
  void deliver(Sample&& sample);
  /// The same for a writer of this process. Gives the sample the next number after `sequence`, so
  /// that the numbers are in the order of delivery, whatever threads the writer is called from.
  void deliver(Sample&& sample, std::uint64_t& sequence);
  /// Whether somebody gets a sample that is delivered now.
  [[nodiscard]] bool has_receivers() const {
    return has_receivers_.load(std::memory_order_relaxed);
  }
  /// From now on `qos` holds in lifespan, minimum separation and deadline.
  void change(const QosProfile& qos, Time now);
  /// An instance ends as `sample`, which has no message, says: at once when it was disposed, with
  /// its last writer when one has unregistered it.
  void end_instance(const Sample& sample);
  /// The writer is gone: what it wrote is not kept for late receivers any more, and instances that
  /// nobody writes now have ended.
  void forget(std::uint64_t source, Time now = Time{});

  struct Account {
    std::uint64_t samples = 0;  ///< delivered
    std::uint64_t thinned = 0;  ///< dropped by minimum_separation_s
    std::uint64_t deadlines_missed = 0;
    Time last{};
  };
  [[nodiscard]] Account account(Time now) const;

 private:
  void hand_over(Sample&& sample);
  void keep(const Sample& sample);
  void tell_end(const Sample& sample);
  [[nodiscard]] bool expired(const Sample& sample, Time now) const;

  const std::size_t kept_per_writer_;
  Duration lifespan_;
  mutable std::mutex mutex_;
  std::vector<Receiver*> receivers_;
  std::atomic<bool> has_receivers_{false};
  using Key = std::pair<std::uint64_t, std::uint64_t>;  // source and instance
  std::map<Key, std::deque<Sample>> kept_;
  InstanceTable instances_;
  Separation separation_;
  DeadlineWatch deadline_;
  std::uint64_t samples_ = 0;
};

}  // namespace tocsin
