// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_budget.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::router {

void RateMeter::add(std::size_t bytes, Time now) {
  sum_ = sum_ * std::exp(-to_seconds(now - at_) / to_seconds(memory)) + static_cast<double>(bytes);
  at_ = now;
}

double RateMeter::bytes_per_s(Time now) const {
  return sum_ * std::exp(-to_seconds(now - at_) / to_seconds(memory)) / to_seconds(memory);
}

double AdaptiveScale::target(const Input& input) const {
  if (input.silent) return params_.scale_min;
  if (input.nominal_bytes_per_s <= 0) return 1;
  const double share_bytes_per_s =
      params_.utilisation * input.capacity_bytes_per_s - input.others_bytes_per_s;
  return std::clamp(share_bytes_per_s / input.nominal_bytes_per_s, params_.scale_min, 1.0);
}

void AdaptiveScale::update(const Input& input, Time now) {
  const double wanted = target(input);
  const double passed_s = updated_ ? to_seconds(now - *updated_) : 0;
  updated_ = now;
  const double constant_s = wanted < smooth_ ? params_.scale_fall_s : params_.scale_rise_s;
  smooth_ += (wanted - smooth_) * -std::expm1(-passed_s / constant_s);
  const bool at_end = wanted == 1 && smooth_ > 1 - params_.scale_step / 2;
  if (at_end) {
    told_ = 1;
  } else if (std::abs(smooth_ - told_) >= params_.scale_step) {
    told_ = smooth_;
  }
}

}  // namespace tocsin::router
