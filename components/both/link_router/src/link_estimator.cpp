// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::router {
namespace {

/// Weights of a new delay in mean and deviation (RFC 6298, 2.3).
constexpr double delay_weight = 1.0 / 8;
constexpr double deviation_weight = 1.0 / 4;
constexpr double loss_weight = 1.0 / 16;
constexpr double capacity_falls = 0.9;  ///< weight of a smaller measurement
constexpr double capacity_rises = 0.2;
/// A measured capacity is believed within these limits: one sample proves no more.
constexpr double least_capacity_bytes_per_s = 4000;
constexpr double most_capacity_bytes_per_s = 1e9;
/// So many unanswered transmissions at least are a silence: one or two may be bad luck.
constexpr int silence_means = 3;
/// Its multiples fill an interval evenly: the same over and over, and no period (Weyl, 1916).
constexpr double golden_ratio = 0.6180339887498949;
/// A service time below this is the clock's grain.
constexpr Duration shortest_service = std::chrono::microseconds(200);

void blend(double& value, double target, double weight) { value += weight * (target - value); }

}  // namespace

void WindowedMinimum::add(Duration value, Time now) {
  if (!current_ || now - begin_ >= half_) {
    if (current_) previous_ = now - begin_ < 2 * half_ ? current_ : std::nullopt;
    begin_ = now;
    current_ = value;
    return;
  }
  current_ = std::min(*current_, value);
}

std::optional<Duration> WindowedMinimum::value() const {
  if (current_ && previous_) return std::min(*current_, *previous_);
  return current_;
}

void SmoothedTime::add(Duration time) {
  const double time_s = to_seconds(time);
  blend(deviation_s_, std::abs(time_s - mean_s_), deviation_weight);
  blend(mean_s_, time_s, delay_weight);
}

Time LinkEstimator::on_sent(const WireCost& cost, Time now, bool of_share) {
  drained_ =
      std::max(drained_, now) + seconds(static_cast<double>(cost.bytes) / capacity_bytes_per_s_);
  paid_ = std::max(paid_, now) + seconds(static_cast<double>(cost.bytes) / limit_bytes_per_s_);
  if (of_share) {
    if (std::exchange(spent_at_, now) != now) phase_ = std::fmod(phase_ + golden_ratio, 1);
    const double takes_s = (0.5 + phase_) * static_cast<double>(cost.bytes) / share_bytes_per_s();
    share_used_ = std::max(share_used_, now) + seconds(takes_s);
  }
  if (!waiting_since_) waiting_since_ = now;
  ++unanswered_;
  return drained_;
}

Duration LinkEstimator::on_received(const Received& received, Time now) {
  waiting_since_ = now;
  unanswered_ = 0;
  blend(loss_, 0, loss_weight);
  const Duration crossing = received.arrived.time_since_epoch() - received.sent.time_since_epoch();
  // Whatever an acknowledgement says of times: it is here by now.
  const Duration most = std::max(now - received.sent, Duration::zero());
  const auto over_least = [&] {
    return std::clamp(crossing - least_.value().value_or(crossing), Duration::zero(), most);
  };
  const bool is_bulk = received.burst != 0 || received.cost.packets >= bulk_packets;
  if (!is_bulk && received.sent >= frozen_) answer_.add(now - received.sent);
  if (!received.is_exact || received.sent < frozen_) return over_least();
  if (is_bulk) {
    if (!least_.value()) return Duration::zero();
    const Duration delay = over_least();
    learn_capacity(received, received.sent + delay);
    return delay;
  }
  least_.add(crossing, now);
  const Duration delay = over_least();
  delay_.add(delay);
  return delay;
}

void LinkEstimator::learn_capacity(const Received& received, Time arrived) {
  if (received.cost.packets < bulk_packets) return;
  if (received.burst == 0 || received.burst != last_.burst) {
    if (last_.per_kilobyte) per_kilobyte_.add(*last_.per_kilobyte, arrived);
    last_ = {received.burst, std::max(received.sent, bulk_arrived_), capacity_bytes_per_s_, {}, {}};
  }
  bulk_arrived_ = std::max(bulk_arrived_, arrived);
  const Duration behind = arrived - received.expected;
  drained_ += behind - last_.behind;
  last_.behind = behind;
  is_capacity_measured_ = measured_ = true;
  const Duration service = std::max(arrived - last_.turn, shortest_service);
  const double measured = std::clamp(static_cast<double>(received.cost.bytes) / to_seconds(service),
                                     least_capacity_bytes_per_s, most_capacity_bytes_per_s);
  last_.per_kilobyte = seconds(1000 / measured);
  capacity_bytes_per_s_ = last_.before_bytes_per_s;
  blend(capacity_bytes_per_s_, measured,
        measured < capacity_bytes_per_s_ ? capacity_falls : capacity_rises);
}

double LinkEstimator::free_bytes_per_s() const {
  const auto least = per_kilobyte_.value();
  return least ? 1000 / to_seconds(*least) : free_start_bytes_per_s;
}

double LinkEstimator::share_bytes_per_s() const {
  if (!airtime_share_) return std::numeric_limits<double>::infinity();
  return std::max(*airtime_share_ * free_bytes_per_s(), 1.0);
}

void LinkEstimator::on_lost() { blend(loss_, 1, loss_weight); }

Duration LinkEstimator::backlog(Time now) const {
  return std::max(std::max({drained_, paid_, share_used_}) - now, Duration::zero());
}

Duration LinkEstimator::expected_delay() const { return seconds(delay_.bound_s()); }

Duration LinkEstimator::expected_answer() const {
  return seconds(std::min(answer_.bound_s(), answer_max_s));
}

bool LinkEstimator::is_silent(Time now, Duration after) const {
  return unanswered_ >= silence_means && waiting_since_ && now - *waiting_since_ > after;
}

void LinkEstimator::on_frozen(Time now) {
  frozen_ = now;
  if (waiting_since_) waiting_since_ = now;
}

void LinkEstimator::start_over(Time now) {
  // Once for each measurement: several outages in a row say no more about the link than one.
  if (measured_)
    capacity_bytes_per_s_ = std::max(capacity_bytes_per_s_ / 2, least_capacity_bytes_per_s);
  measured_ = false;
  drained_ = now;
  delay_ = {};
  waiting_since_.reset();
  unanswered_ = 0;
}

}  // namespace tocsin::router
