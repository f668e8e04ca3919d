// SPDX-License-Identifier: Apache-2.0
#include "link_router/airtime_keeper.hpp"

#include <algorithm>

namespace tocsin::router {
namespace {

/// What is told below this would be a muted vehicle.
constexpr double least_share = 0.001;

bool is_share(double value) { return value >= 0 && value <= 1; }  // false for NaN

}  // namespace

void AirtimeKeeper::on_share(double share, double fallback, Time now) {
  if (is_share(share) && is_share(fallback)) told_ = Told{share, fallback, now};
}

std::optional<double> AirtimeKeeper::share(Time now) const {
  if (!told_) return std::nullopt;
  const double share = now - told_->at > silence_limit ? told_->fallback : told_->share;
  if (share >= 1) return std::nullopt;
  return std::max(share, least_share);
}

Time AirtimeKeeper::deadline(Time now) const {
  if (!told_ || now - told_->at > silence_limit) return never;
  return told_->at + silence_limit + Duration{1};
}

}  // namespace tocsin::router
