// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "foundation/time.hpp"

namespace tocsin {

/// `max_rate_hz`: passes so many samples a second at most, in the long run. One that comes up to
/// an interval early passes, so that jitter does not halve a stream of exactly that rate. Pure.
class RateLimit {
 public:
  /// `interval` > 0 between samples.
  explicit RateLimit(Duration interval) : interval_(interval) {}
  [[nodiscard]] bool pass(Time now);
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
  /// From the next sample on.
  void change(Duration interval) { interval_ = interval; }

 private:
  Duration interval_;
  Time next_{};  ///< when the next sample is due at an even rate
  std::uint64_t dropped_ = 0;
};

/// `minimum_separation_s`: of each writer and instance, passes a sample only so long after the one
/// that it passed before. Pure.
class Separation {
 public:
  /// Zero passes everything.
  explicit Separation(Duration least) : least_(least) {}
  [[nodiscard]] bool pass(std::uint64_t source, Time now, std::uint64_t instance = 0) {
    return least_ <= Duration::zero() || is_apart({source, instance}, now);
  }
  /// The writer is gone.
  void forget(std::uint64_t source) {
    last_.erase(last_.lower_bound({source, 0}), last_.upper_bound({source, last_instance}));
  }
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
  void change(Duration least) { least_ = least; }

 private:
  using Key = std::pair<std::uint64_t, std::uint64_t>;  // source and instance
  static constexpr std::uint64_t last_instance = std::numeric_limits<std::uint64_t>::max();
  [[nodiscard]] bool is_apart(const Key& key, Time now);
  Duration least_;
  std::map<Key, Time> last_;
  std::uint64_t dropped_ = 0;
};

/// `deadline_s`: counts the periods that passed without a sample, from the first sample on. Pure.
class DeadlineWatch {
 public:
  /// An infinite `period` (Duration::max()) is never missed.
  explicit DeadlineWatch(Duration period) : period_(period) {}
  void on_sample(Time now) {
    if (period_ != Duration::max()) missed_ = missed(now);
    last_ = now;
  }
  /// Whole periods without a sample up to `now`, since the start.
  [[nodiscard]] std::uint64_t missed(Time now) const;
  /// Of the last sample; zero: none yet.
  [[nodiscard]] Time last() const { return last_; }
  /// What was missed until `now` stays counted; the new period begins then.
  void change(Duration period, Time now) {
    missed_ = missed(now);
    changed_ = now;
    period_ = period;
  }

 private:
  Duration period_;
  Time changed_{};
  Time last_{};
  std::uint64_t missed_ = 0;
};

}  // namespace tocsin
