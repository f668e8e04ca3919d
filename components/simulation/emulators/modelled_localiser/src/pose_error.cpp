// SPDX-License-Identifier: Apache-2.0
#include "modelled_localiser/pose_error.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

constexpr double carried_m = 1;  // between two readings, which no wheels do

}  // namespace

PoseError::PoseError(const PoseErrorParams& params, std::uint64_t seed)
    : params_(params), random_(seed) {}

std::optional<geometry::Pose> PoseError::read(const geometry::Pose& truth, Time now) {
  const bool lost = is_lost(truth, now);
  drift(now);
  last_ = now;
  last_truth_ = truth;
  if (lost) return std::nullopt;
  return geometry::Pose{
      truth.x_m + params_.deviation_m * error_.x_m, truth.y_m + params_.deviation_m * error_.y_m,
      geometry::wrap_angle(truth.heading_rad + params_.deviation_rad * error_.heading_rad)};
}

/// Exact for any step: what is kept of the old error, and fresh noise that keeps its deviation 1.
void PoseError::drift(Time now) {
  const double kept = last_ ? std::exp(-to_seconds(now - *last_) / params_.correlation_s) : 0;
  const double fresh = std::sqrt(1 - kept * kept);
  for (double* const one : {&error_.x_m, &error_.y_m, &error_.heading_rad}) {
    *one = kept * *one + fresh * normal_(random_);
  }
}

bool PoseError::is_lost(const geometry::Pose& truth, Time now) {
  const Duration lasts = seconds(params_.lost_for_s);
  if (last_ && distance(position(last_truth_), position(truth)) > carried_m) {
    lost_until_ = now + lasts;
  }
  if (params_.lost_every_s > 0) {
    std::exponential_distribution<> until(1 / params_.lost_every_s);
    if (!next_loss_) next_loss_ = now + seconds(until(random_));
    while (*next_loss_ <= now) {
      lost_until_ = std::max(lost_until_, *next_loss_ + lasts);
      next_loss_ = *next_loss_ + lasts + seconds(until(random_));
    }
  }
  return now < lost_until_;
}

}  // namespace tocsin
