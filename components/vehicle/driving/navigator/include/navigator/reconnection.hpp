// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigation/cost_map.hpp"
#include "navigation/link_risk.hpp"

namespace tocsin {

/// Where to drive while the link is lost: to the place from which the goal is reached soonest in
/// the mean, with the way there, the chance that the link is back there, and the way on to the
/// goal; then to the next such place. As RCAMP does (Caccamo, Parasuraman and Ogren 2017), and not
/// back along the track.
///
/// Pure; `now` must not decrease.
class Reconnection {
 public:
  struct Params {
    double reconnect_within_m = 30;
    double reconnect_wait_s = 5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("reconnect_within_m", reconnect_within_m, {1, 1000},
        "[m] driven at most to be heard again, then it holds");
      v("reconnect_wait_s", reconnect_wait_s, {1, 300}, "[s] it waits at each place");
    }
  };

  explicit Reconnection(const Params& params) : params_(params) {}

  /// The link is there; what was tried is forgotten.
  void end();
  [[nodiscard]] bool is_on() const { return began_; }
  /// A place to drive to, chosen by a vehicle at `from` that drives at `speed_mps`, the same until
  /// it was given up; empty when there is none within what is left of `reconnect_within_m`.
  [[nodiscard]] std::optional<geometry::Point> place(const navigation::CostMap& costs,
                                                     const navigation::LinkRisk& risk,
                                                     const geometry::Point& from,
                                                     const geometry::Point& goal, double speed_mps);
  /// It stands there: after `reconnect_wait_s` the next place will be another one.
  /// True once it is given up.
  bool on_arrival(Time now);
  /// It cannot get there.
  void give_up();

 private:
  struct Place {
    geometry::Point at;
    double way_m;  // to it
  };
  [[nodiscard]] std::optional<Place> best(const navigation::CostMap& costs,
                                          const navigation::LinkRisk& risk,
                                          const geometry::Point& from, const geometry::Point& goal,
                                          double speed_mps) const;
  [[nodiscard]] bool is_tried(const geometry::Point& at) const;

  Params params_;
  bool began_ = false;
  double left_m_ = 0;
  std::optional<geometry::Point> place_;
  std::optional<Time> arrived_;
  std::vector<geometry::Point> tried_;
};

}  // namespace tocsin
