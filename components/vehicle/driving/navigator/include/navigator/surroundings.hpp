// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigation/cost_percent.hpp"
#include "navigation/link_risk.hpp"
#include "navigation/link_way.hpp"
#include "navigation/obstacle_layer.hpp"
#include "navigation/occupancy_map.hpp"
#include "navigation/planner.hpp"

namespace tocsin {

/// What of the floor a vehicle may drive on: the map, and what its laser sees besides.
///
/// Pure; `now` must not decrease.
class Surroundings {
 public:
  struct Params {
    bool avoid_obstacles = false;
    navigation::ObstacleParams obstacles;
    double scan_timeout_s = 1;
    double replan_period_s = 1;
    double link_detour = 0;
    template <class Visitor>
    void visit(Visitor& v) {
      v("avoid_obstacles", avoid_obstacles, "whether it drives round what a laser sees on `scan`");
      obstacles.visit(v);
      v("scan_timeout_s", scan_timeout_s, {0.1, 10}, "[s] an older scan stops the vehicle");
      v("replan_period_s", replan_period_s, {0.1, 60}, "[s] between plans round new obstacles");
      v("link_detour", link_detour, {0, 1},
        "[1] a way that keeps the link (`link_risk`) is longer by this share at most; 0: the "
        "shortest");
    }
  };

  /// `costs` of this map, by `inflation`.
  Surroundings(const Params& params, const navigation::InflationParams& inflation,
               navigation::OccupancyMap map, std::shared_ptr<const navigation::CostMap> costs);

  /// Another map; a new plan is wanted.
  void set_map(const navigation::OccupancyMap& map);
  /// A turn of the laser, measured by a vehicle at `pose` (frame map).
  void on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now);
  /// The vehicle has touched something there, or the floor ends.
  void on_touch(const geometry::Point& at, Time now);
  /// Where the link is lost; what is planned from now on heeds it as far as `link_detour` says.
  void set_link(navigation::LinkRisk risk);
  [[nodiscard]] const std::optional<navigation::LinkRisk>& link() const { return link_; }
  /// What may be driven on, without what is seen besides.
  [[nodiscard]] const navigation::CostMap& costs() const { return *costs_; }
  /// The grid of all of it, and costs as Nav2's costmaps tell them of a part [%], see
  /// cost_percents.
  [[nodiscard]] const navigation::Grid& grid() const { return map_.grid(); }
  [[nodiscard]] std::vector<std::int8_t> cost_percents(const navigation::CellWindow& window) const;
  /// Forgets what was seen and touched besides the map.
  void clear_obstacles() { obstacles_.clear_all(); }
  /// False where obstacles are avoided and no scan has come for `scan_timeout_s`.
  [[nodiscard]] bool sees(Time now) const;

  /// The way round all that is known, where there is none with the margin, closer to obstacles;
  /// where there is none either, through what has come lately and may walk (ObstacleLayer's
  /// lasting_cells). Empty: there is none.
  [[nodiscard]] std::optional<geometry::Path> plan(const geometry::Point& from,
                                                   const geometry::Point& to, Time now);
  /// The next plan leads to another goal.
  void begin_way() { chooser_.begin(); }
  /// How the last plan was chosen; empty where the link is not known, or not heeded.
  [[nodiscard]] const std::optional<navigation::WayChoice>& choice() const { return choice_; }
  /// Whether obstacles, or what is known of the link, have changed since the last plan, which is
  /// `replan_period_s` old.
  [[nodiscard]] bool wants_plan(Time now) const;

  /// Whether a disc there touches a wall or an obstacle.
  [[nodiscard]] bool collides(double x_m, double y_m, double radius_m) const;
  /// Whether no disc that lies within `reach_m` of there does. False may be wrong.
  [[nodiscard]] bool is_clear(double x_m, double y_m, double reach_m) const;
  /// To the nearest obstacle that is not on the map [m]; `most_m` when it is farther.
  [[nodiscard]] double obstacle_distance_m(const geometry::Point& from, double most_m) const;

 private:
  [[nodiscard]] std::optional<geometry::Path> shortest(const geometry::Point& from,
                                                       const geometry::Point& to, Time now);
  [[nodiscard]] std::optional<geometry::Path> plan_tight(
      const std::vector<navigation::CellIndex>& obstacles, const geometry::Point& from,
      const geometry::Point& to) const;
  void plan_over(std::shared_ptr<const navigation::CostMap> costs);
  Params params_;
  navigation::InflationParams inflation_;
  navigation::OccupancyMap map_;
  bool is_growing_ = false;  ///< another map has come
  std::shared_ptr<const navigation::CostMap> costs_;
  std::shared_ptr<const navigation::CostMap> planned_costs_;  ///< of `planner_`
  navigation::Planner planner_;
  navigation::ObstacleLayer obstacles_;
  std::optional<Time> seen_;
  std::optional<Time> planned_;
  std::uint64_t planned_version_ = 0;
  std::optional<navigation::LinkRisk> link_;
  std::vector<float> link_cells_;  ///< of it, on the floor's grid
  bool has_new_link_ = false;
  navigation::LinkWayChooser chooser_;
  std::optional<navigation::WayChoice> choice_;
};

}  // namespace tocsin
