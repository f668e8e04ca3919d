// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_budget.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "link_router/link_constants.hpp"
namespace tocsin::router {
namespace {

constexpr Duration scale_period = std::chrono::milliseconds(50);
/// A measured nominal rate is forgotten with this time constant.
constexpr double peak_memory_s = 20;

}  // namespace

void RateMeter::add(std::size_t bytes, Time now) {
  sum_ = sum_ * std::exp(-to_seconds(now - at_) / to_seconds(memory)) + static_cast<double>(bytes);
  at_ = now;
}

double RateMeter::bytes_per_s(Time now) const {
  return sum_ * std::exp(-to_seconds(now - at_) / to_seconds(memory)) / to_seconds(memory);
}

double AdaptiveScale::target(const Input& input) {
  bound_by_share_ = false;
  if (input.silent) return params_.scale_min;
  if (input.nominal_bytes_per_s <= 0) return 1;
  const double room_bytes_per_s = std::min(
      utilisation * input.capacity_bytes_per_s - input.others_bytes_per_s, input.share_bytes_per_s);
  return std::clamp(room_bytes_per_s / input.nominal_bytes_per_s, params_.scale_min, 1.0);
}

void AdaptiveScale::update(const Input& input, Time now) {
  const double wanted = target(input);
  const double passed_s = updated_ ? to_seconds(now - *updated_) : 0;
  updated_ = now;
  if (std::exchange(falls_at_once_, false)) smooth_ = std::min(smooth_, wanted);
  const double constant_s = wanted < smooth_ ? scale_fall_s : scale_rise_s;
  smooth_ += (wanted - smooth_) * -std::expm1(-passed_s / constant_s);
  const bool at_end = wanted == 1 && smooth_ > 1 - scale_step / 2;
  if (at_end) {
    reported_ = 1;
  } else if (std::abs(smooth_ - reported_) >= scale_step) {
    reported_ = smooth_;
  }
}

void LinkAdaptation::on_offered(StreamId stream, const WireCost& cost, Time now) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  Stream& to = found->second;
  if (to.offered != Time::min()) {
    to.peak_bytes_per_s *= std::exp(-to_seconds(now - to.offered) / peak_memory_s);
  }
  to.offered = now;
  const double nominal = static_cast<double>(cost.bytes) / scale_.scale();
  to.nominal.add(static_cast<std::size_t>(nominal), now);
  to.peak_bytes_per_s = std::max(to.peak_bytes_per_s, to.nominal.bytes_per_s(now));
}

void LinkAdaptation::follow(const LinkedPeers& peers, Time now) {
  if (updated_ != Time::min() && now - updated_ < scale_period) return;
  updated_ = now;
  AdaptiveScale::Input input;
  input.capacity_bytes_per_s = peers.capacity_bytes_per_s(now);
  input.share_bytes_per_s = peers.share_bytes_per_s(now);
  input.others_bytes_per_s = others_.bytes_per_s(now);
  for (const auto& entry : streams_) input.nominal_bytes_per_s += entry.second.peak_bytes_per_s;
  input.silent = peers.is_silent(now);
  scale_.update(input, now);
}

std::vector<StreamBudget> LinkAdaptation::budgets(
    const std::function<bool(StreamId)>& holds) const {
  std::vector<StreamBudget> budgets;
  for (const auto& [id, stream] : streams_) {
    budgets.push_back({id, scale() * stream.peak_bytes_per_s, scale(), holds(id)});
  }
  return budgets;
}

}  // namespace tocsin::router
