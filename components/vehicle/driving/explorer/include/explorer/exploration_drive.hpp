// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "exploration/explorer.hpp"
#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin {

/// When goals of an exploration are sent, and what becomes of them. Pure; `now` does not decrease.
class ExplorationDrive {
 public:
  struct Params {
    bool autostart = false;
    bool exit_when_over = false;
    double choose_every_s = 1;
    double goal_timeout_s = 120;
    double stall_timeout_s = 8;
    double pose_timeout_s = 3;
    double settle_s = 2;
    exploration::ExplorerParams explorer;
    template <class Visitor>
    void visit(Visitor& v) {
      v("autostart", autostart, "whether to explore from the start on");
      v("exit_when_over", exit_when_over, "end the process when all is known; code 0");
      v("choose_every_s", choose_every_s, {0.1, 60}, "[s] between choices while it drives");
      v("goal_timeout_s", goal_timeout_s, {1, 3600}, "[s] a goal that takes longer has failed");
      v("stall_timeout_s", stall_timeout_s, {1, 3600}, "[s] without moving, a goal has failed");
      v("pose_timeout_s", pose_timeout_s, {0.1, 60}, "[s] with older poses no goal is chosen");
      v("settle_s", settle_s, {0, 60}, "[s] until the map shows what is seen from a goal");
      explorer.visit(v);
    }
  };
  /// What to do at once.
  struct Order {
    std::optional<geometry::Pose> drive_to;  ///< a new goal, which replaces the present one
    bool cancel = false;                     ///< the present goal
  };

  explicit ExplorationDrive(const Params& params);

  /// Begins anew, whatever was given up before. While it explores it goes on.
  void start();
  /// Ends; the present goal is canceled.
  void stop() { is_stopping_ = is_running_; }
  void on_map(navigation::OccupancyMap map) { map_ = std::move(map); }
  /// A pose that is not finite is ignored.
  void on_pose(const geometry::Pose& pose, Time now);
  void on_navigator(bool is_there) { has_navigator_ = is_there; }
  /// Of the present goal.
  void on_reached(Time now);
  void on_failed(const std::string& reason);
  /// The navigator takes no goal now: sent again after 5 s; after a minute of it the goal has
  /// failed.
  void on_rejected(const std::string& reason, Time now);

  [[nodiscard]] Order update(Time now);
  /// "idle", "waiting: ...", "exploring: ..." or "done: ...".
  [[nodiscard]] const std::string& status() const { return status_; }
  [[nodiscard]] bool is_running() const { return is_running_; }
  /// When to update again without news.
  [[nodiscard]] Time next() const { return next_; }

 private:
  [[nodiscard]] const char* missing(Time now) const;
  Order choose(Time now);
  Order finish(std::string status);
  Order drive_to(const geometry::Point& goal, Time now);

  const Params params_;
  exploration::Explorer explorer_;
  std::optional<navigation::OccupancyMap> map_;
  std::optional<geometry::Pose> pose_;
  std::string status_ = "idle";
  Time pose_at_{};
  Time next_{};
  geometry::Pose moved_pose_;  ///< where it last was seen to move
  Time moved_at_{};
  Time give_up_at_{};
  int rejections_ = 0;
  bool has_navigator_ = false;
  bool is_running_ = false;
  bool is_stopping_ = false;
  bool is_driving_ = false;
};

}  // namespace tocsin
