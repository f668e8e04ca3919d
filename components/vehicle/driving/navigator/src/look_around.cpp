// SPDX-License-Identifier: Apache-2.0
#include "navigator/look_around.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

constexpr Duration stands_for = std::chrono::seconds(3);
constexpr Duration turns_until = std::chrono::seconds(33);
constexpr Duration drives_until = std::chrono::seconds(43);
constexpr Duration newest_scan = std::chrono::milliseconds(500);
constexpr geometry::Twist turning{0, 0.5};
constexpr geometry::Twist driving{0.2, 0};
constexpr double half_width_m = 0.25;  // of the way ahead: the vehicle's, and a margin
constexpr double farthest_m = 4;
constexpr double free_to_begin_m = 1;
constexpr double free_to_go_on_m = 0.5;

}  // namespace

void LookAround::on_scan(const laser::Scan& scan, Time now) {
  seen_ = now;
  free_m_ = scan.hits.empty() ? 0 : farthest_m;
  for (const geometry::Point& hit : scan.hits) {
    if (hit.x_m > 0 && std::abs(hit.y_m) <= half_width_m) free_m_ = std::min(free_m_, hit.x_m);
  }
}

geometry::Twist LookAround::next(Time now) {
  if (!since_) since_ = now;
  const Duration phase = (now - *since_) % drives_until;
  is_driving_ = phase > turns_until && is_free_ahead(now);
  if (phase <= stands_for) return {};
  return is_driving_ ? driving : turning;
}

bool LookAround::is_free_ahead(Time now) const {
  if (!seen_ || now - *seen_ > newest_scan) return false;
  return free_m_ >= (is_driving_ ? free_to_go_on_m : free_to_begin_m);
}

}  // namespace tocsin
