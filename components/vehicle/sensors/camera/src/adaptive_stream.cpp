// SPDX-License-Identifier: Apache-2.0
#include "camera/adaptive_stream.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tocsin::camera {
namespace {

constexpr double rate_share = 0.1;
constexpr double least_size = 0.1;
constexpr double most_due = 2;  ///< pictures that a source may catch up with
constexpr Duration budget_lasts = std::chrono::seconds(2);

}  // namespace

void AdaptiveStream::set_budget(double scale, bool hold, Time now) {
  scale_ = std::clamp(scale, 0.0, 1.0);
  hold_ = hold;
  renewed_ = now;
}

std::optional<double> AdaptiveStream::next(Time now) {
  const bool old = renewed_ == Time::min() || now - renewed_ > budget_lasts;
  if (old) return 1;
  due_ = std::min(due_ + std::pow(scale_, rate_share), most_due);
  if (hold_ || due_ < 1) return std::nullopt;
  due_ -= 1;
  return std::max(std::pow(scale_, 1 - rate_share), least_size);
}

int QualityLaw::quality_for(double share) const {
  const double wanted = share * bytes_.rbegin()->second;
  const auto above = std::find_if(bytes_.begin(), bytes_.end(),
                                  [wanted](const auto& entry) { return entry.second > wanted; });
  if (above == bytes_.begin()) return above->first;
  const auto below = std::prev(above);
  if (above == bytes_.end()) return below->first;
  const double part = (wanted - below->second) / (above->second - below->second);
  return static_cast<int>(std::floor(below->first + part * (above->first - below->first)));
}

}  // namespace tocsin::camera
