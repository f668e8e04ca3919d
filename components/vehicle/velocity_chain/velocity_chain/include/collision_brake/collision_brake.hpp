// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "laser_geometry/scan.hpp"

namespace tocsin {

/// What a vehicle may do that does not see.
enum class WithoutScan { stop, crawl, pass };
constexpr std::array<const char*, 3> words_of(WithoutScan) { return {"stop", "crawl", "pass"}; }

/// Limits the speed so that the vehicle stands before what its laser sees, on the arc that it is
/// told to drive and on the one that it is on. Needs no map and no place on one: odometry only,
/// for the way since the scan.
///
/// With t the dead time, a the deceleration, u the speed at which what is ahead comes nearer by
/// itself and s the free way on the arc, the speed v obeys v t + v^2 / (2 a) + u (t + v / a) <= s.
/// Turning on the spot is always allowed: the body is a disc. What stands within the margin already
/// may be left, and passed when it is beside (60 degrees and more), up to a centimetre. Pure; `now`
/// must not decrease.
class CollisionBrake {
 public:
  struct Params {
    double body_radius_m = 0.18;
    double margin_m = 0.04;
    double deceleration_mps2 = 1.0;
    double dead_time_s = 0.25;
    double scan_timeout_s = 0.6;
    WithoutScan without_scan = WithoutScan::stop;
    double crawl_mps = 0.1;
    double covered_sector_deg = 60;
    double walking_mps = 0.8;
    double bypass_s = 10;
    template <class Visitor>
    void visit(Visitor& v) {
      v("body_radius_m", body_radius_m, {0.05, 1}, "[m] of a disc that holds the vehicle");
      v("margin_m", margin_m, {0, 0.5}, "[m] kept free round it");
      v("deceleration_mps2", deceleration_mps2, {0.1, 5},
        "[m/s2] that smoother and base reach for sure");
      v("dead_time_s", dead_time_s, {0.05, 2}, "[s] from a scan to wheels that begin to brake");
      v("scan_timeout_s", scan_timeout_s, {0.1, 5}, "[s] an older scan, or odometry, is none");
      visit_enum(v, "without_scan", without_scan, Choices{"stop", "crawl", "pass"},
                 "what is allowed without a scan, and towards where none is seen");
      v("crawl_mps", crawl_mps, {0.02, 0.3}, "[m/s] of `crawl`");
      v("covered_sector_deg", covered_sector_deg, {10, 360},
        "[deg] so wide a part of the turn that loses all returns at once is covered");
      v("walking_mps", walking_mps, {0, 3},
        "[m/s] at which what moves may come into the way; 0: it is taken for standing");
      v("bypass_s", bypass_s, {1, 60}, "[s] it is off after a person has asked for that");
    }
  };

  /// What was done to a velocity.
  enum class Action { none, stop, approach, limit };
  struct Verdict {
    geometry::Twist velocity;
    Action action = Action::none;
    const char* reason = "";  ///< obstacle, no_scan, no_odometry, stuck_scan, blind, bypass
  };

  explicit CollisionBrake(const Params& params) : params_(params) {}

  /// Where the vehicle is, in a frame that stands still, and how it moves.
  void on_pose(const geometry::Pose& pose, const geometry::Twist& velocity, Time now);
  /// A turn of the laser, measured where the vehicle was at `pose` in that frame.
  void on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now);
  /// A person wants to drive without the brake, or with it again.
  void on_bypass(bool wanted, Time now);
  [[nodiscard]] bool is_bypassed(Time now) const { return now < bypassed_until_; }

  /// What of a wanted velocity may be driven. NaN or infinity is a stop.
  [[nodiscard]] Verdict check(const geometry::Twist& wanted, Time now) const;

 private:
  static constexpr std::size_t sectors = 72;
  using Sectors = std::array<bool, sectors>;

  [[nodiscard]] const char* reason_of_blindness(Time now) const;
  [[nodiscard]] Verdict without_sight(const geometry::Twist& wanted, const char* reason) const;
  [[nodiscard]] bool sees_towards(double bearing_rad) const;
  /// [m/s] on the arc of this velocity.
  [[nodiscard]] double allowed_mps(const geometry::Twist& arc) const;
  [[nodiscard]] double free_way_m(const laser::Points& points, const geometry::Twist& arc) const;
  void find_walkers(const laser::Scan& scan, const geometry::Pose& pose, Time now);
  void note_reach(const laser::Scan& scan);
  [[nodiscard]] double allowed_by_walkers_mps(const geometry::Twist& arc) const;
  void look_for_sectors(const laser::Scan& scan);
  void find_covered(const Sectors& has_return);

  Params params_;
  geometry::Pose pose_;
  geometry::Twist velocity_;
  std::optional<Time> pose_time_;
  laser::Points points_;  ///< of the last scan, in the standing frame
  laser::Points before_;  ///< of the one before it
  std::optional<Time> scan_time_;
  double period_s_ = 0;  ///< between the two
  geometry::Pose scan_pose_;
  std::optional<laser::Scan> last_scan_;
  std::optional<Time> same_since_;
  Sectors is_seen_{};
  Sectors had_return_{};  ///< in the last scan
  Sectors is_covered_{};
  static constexpr std::size_t degrees = 360;
  struct Walker {
    geometry::Point at;  ///< standing frame
    Time seen;
  };
  std::vector<Walker> walkers_;
  std::array<double, degrees> reach_{};  ///< [m] of the last scan by bearing, frame of the vehicle
  geometry::Point scan_laser_;
  Time bypassed_until_ = Time::min();
};

}  // namespace tocsin
