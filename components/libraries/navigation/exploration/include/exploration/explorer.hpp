// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exploration/frontier.hpp"
#include "navigation/cost_map.hpp"

namespace tocsin::exploration {

struct ExplorerParams {
  double least_frontier_m = 0.2;
  double most_gain_m = 3.0;
  double hysteresis = 1.5;
  navigation::InflationParams inflation;
  template <class Visitor>
  void visit(Visitor& v) {
    v("least_frontier_m", least_frontier_m, {0, 5}, "[m] shorter frontiers are left unknown");
    v("most_gain_m", most_gain_m, {0.1, 100}, "[m] longer frontiers are worth no more");
    v("hysteresis", hysteresis, {1, 100}, "[1] so much better another goal must be to replace one");
    inflation.visit(v);
  }
};

/// A place that is not driven to any more.
struct Listed {
  geometry::Point place;
  std::string reason;
};

/// Where to drive next.
struct Step {
  enum class What {
    drive,  ///< to `goal`, which is a new one
    keep,   ///< on to `goal`
    wait,   ///< and ask again, with what is seen meanwhile; `reason` says why
    done,   ///< `reason` says why
  };
  What what = What::wait;
  geometry::Point goal;
  std::string reason;
};

/// Chooses frontiers by gain and way until none is left. Ends on any map and whatever becomes of
/// its goals, once no frontier was found three times in a row: a place that fails twice, is reached
/// twice to no avail, or is chosen eight times is listed, and a map has a limited number of places,
/// squares of 0.5 m.
///
/// What no way leads to with the margin to walls is looked for without; the navigator may fail
/// there.
///
/// Pure. Gain / cost = length of the frontier / (way + 1 m), the length limited to `most_gain_m`.
class Explorer {
 public:
  explicit Explorer(const ExplorerParams& params) : params_(params) {}

  /// What to do with what is known now, the robot at `robot`. Asks as often as the map changes or
  /// a goal has ended. A robot that is not on the map, or not finite, waits; after ten times it is
  /// done.
  [[nodiscard]] Step next(const navigation::OccupancyMap& map, const geometry::Point& robot);
  /// The present goal has ended.
  void on_reached();
  void on_failed(const std::string& reason);

  [[nodiscard]] const std::optional<geometry::Point>& goal() const { return goal_; }
  [[nodiscard]] const std::vector<Listed>& listed() const { return listed_; }

 private:
  struct Tally {
    int chosen = 0;
    int failed = 0;
    int reached = 0;
    bool is_listed = false;
  };
  using Place = std::pair<long, long>;
  struct Candidate {
    geometry::Point goal;
    double score = 0;
  };
  [[nodiscard]] static Place place_of(const geometry::Point& p);
  [[nodiscard]] bool is_listed(const geometry::Point& p) const;
  [[nodiscard]] std::optional<Candidate> candidate(const Frontier& frontier,
                                                   const navigation::DistanceField& ways) const;
  [[nodiscard]] double score_of(const Frontier& frontier, double way_m) const;
  /// Of the present goal, if its frontier is still there.
  [[nodiscard]] double present_score(const std::vector<Frontier>& frontiers,
                                     const navigation::DistanceField& ways) const;
  std::optional<Step> step_within(const navigation::OccupancyMap& map, const geometry::Point& robot,
                                  const navigation::InflationParams& inflation);
  Step choose(const geometry::Point& goal);
  Step wait();
  Step look_again();
  Step finish();
  void list(const geometry::Point& place, std::string reason);

  ExplorerParams params_;
  std::optional<geometry::Point> goal_;
  std::map<Place, Tally> tallies_;
  std::vector<Listed> listed_;
  int waited_ = 0;
  int looked_ = 0;
};

}  // namespace tocsin::exploration
