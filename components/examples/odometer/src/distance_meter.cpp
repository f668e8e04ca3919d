// SPDX-License-Identifier: Apache-2.0
#include "odometer/distance_meter.hpp"

#include <cmath>

namespace example {

void DistanceMeter::on_position(double x_m, double y_m) {
  if (!std::isfinite(x_m) || !std::isfinite(y_m)) return;
  const double way_m = last_ ? std::hypot(x_m - last_->x_m, y_m - last_->y_m) : 0;
  if (last_ && way_m < step_m_) return;
  if (way_m <= jump_m_) driven_m_ += way_m;
  last_ = Position{x_m, y_m};
}

}  // namespace example
