// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "decision/outlook.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigation/link_risk.hpp"

namespace tocsin {

/// What a vehicle's plan and a map of the link say of the next minute.
///
/// Pure; `now` must not decrease.
class WayAhead {
 public:
  /// The speed at which plans are driven, above 0.
  explicit WayAhead(double speed_mps) : speed_mps_(speed_mps) {}

  void set_plan(geometry::Path path);
  void set_risk(navigation::LinkRisk risk) { risk_ = std::move(risk); }
  /// Where the vehicle is; what is not finite is ignored.
  void set_place(const geometry::Point& at, Time now);

  /// Along the plan at its speed, then its end. One place for a vehicle that stands (0.2 m in 3 s).
  /// Nothing where the map or the place is not known, is older than 2 s, or is beside the plan by
  /// more than 1 m.
  [[nodiscard]] decision::Outlook outlook(Time now) const;

 private:
  [[nodiscard]] bool stands(Time now) const;
  [[nodiscard]] decision::Outlook along(std::size_t corner, double share) const;

  double speed_mps_;
  geometry::Path plan_;
  std::optional<navigation::LinkRisk> risk_;
  std::optional<geometry::Point> place_;
  Time placed_{};
  geometry::Point moved_from_;
  Time moved_{};
};

}  // namespace tocsin
