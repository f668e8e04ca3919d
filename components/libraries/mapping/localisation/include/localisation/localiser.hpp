// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "foundation/numbers.hpp"
#include "foundation/parameters.hpp"
#include "geometry/pose.hpp"
#include "laser_geometry/scan.hpp"
#include "localisation/beam_model.hpp"
#include "localisation/distance_map.hpp"
#include "localisation/global_search.hpp"
#include "localisation/map_match.hpp"
#include "localisation/recent_scans.hpp"
#include "localisation/scan_motion.hpp"
#include "navigation/occupancy_map.hpp"

namespace tocsin::localisation {

struct LocaliserParams {
  double odometry_share = 0.05;
  double odometry_turn_share = 0.05;
  double lost_below = 0.4;
  template <class Visitor>
  void visit(Visitor& v) {
    v("odometry_share", odometry_share, {0.001, 1}, "[1] deviation of odometry per metre driven");
    v("odometry_turn_share", odometry_turn_share, {0.001, 1},
      "[1] deviation of odometry per radian turned");
    v("lost_below", lost_below, {0, 0.9}, "[1] less of a scan is explained by the map: lost");
  }
};

/// How sure a localiser is. Nothing drives by a pose that is not tracked.
enum class Health { lost, uncertain, tracked };
constexpr std::array<const char*, 3> words_of(Health) { return {"lost", "uncertain", "tracked"}; }

/// Where a vehicle with a laser is on a known map.
///
/// It keeps up to 80 hypotheses. Each is moved by odometry and matched to the map (`match`); what
/// its beams meet is evidence for or against it (`BeamModel`). Evidence counts when the vehicle has
/// moved, a few times where it stands, and fades, so that two rooms that are alike stay two
/// hypotheses. Until one is sure, poses everywhere are tried again, in parts, scan by scan, so that
/// no update takes long; the first time at once. A new one is asked what it would have seen on the
/// last metres (`RecentScans`).
///
/// Once it is sure it stays so while each scan shows what the one before did: only beams through
/// walls, a jump, or a place beside it that fits better are reasons for doubt.
///
/// Pure and deterministic.
class Localiser {
 public:
  struct Hypothesis {
    Belief belief;
    double evidence = 0;    ///< logarithm of its weight
    double explained = 1;   ///< share of beams that end at walls, smoothed over a second or so
    double through = 0;     ///< share of beams that end behind walls, likewise
    double weight = 0;      ///< [range 0,1] of all hypotheses together
    bool is_fresh = false;  ///< no scan has been seen from it yet
  };
  struct Estimate {
    Belief belief;  ///< of the likeliest hypothesis; its covariance tells of the others, too; at
                    ///< least 1 m2 while it is not tracked
    Health health = Health::uncertain;
    double explained = 0;
  };

  Localiser(navigation::OccupancyMap map, const LocaliserParams& params);
  Localiser(const Localiser&) = delete;
  Localiser& operator=(const Localiser&) = delete;

  /// The vehicle is there, to about `deviation_m` and `deviation_rad`.
  void start_at(const geometry::Pose& pose, double deviation_m, double deviation_rad);
  /// It may be anywhere: tried with the next scan.
  void start_anywhere();
  /// A scan, and where odometry said the vehicle was when it was made. Empty before the first
  /// start, and for a scan without hits or one that is the last again.
  std::optional<Estimate> update(const laser::Scan& scan, const geometry::Pose& odom);
  /// The next scan is evidence though the vehicle has not moved.
  void count_next() { moved_ = infinity; }
  [[nodiscard]] const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }

 private:
  void stay();
  void doubt();
  void move(const laser::Points& hits, const geometry::Pose& odom);
  void settle(Hypothesis& hypothesis, const laser::Points& hits);
  void weigh(const laser::Scan& scan);
  void begin_search(const laser::Points& hits);
  void end_search();
  void search(const laser::Scan& scan, const laser::Points& hits);
  void look_around(const laser::Scan& scan, const laser::Points& hits);
  void try_candidates(const laser::Scan& scan, const laser::Points& hits, std::size_t most);
  void add(const Belief& belief, double evidence, const Evidence& seen);
  void prune();
  void jump(const geometry::Pose& from);
  void unfollow();
  [[nodiscard]] bool wants_search() const;
  [[nodiscard]] double lead_of_best() const;
  [[nodiscard]] bool stays_followed() const;
  [[nodiscard]] double patience() const;
  [[nodiscard]] bool is_sure() const;
  [[nodiscard]] Health health_of_best();
  [[nodiscard]] Estimate estimate();

  navigation::OccupancyMap map_;
  DistanceMap distances_;
  LocaliserParams params_;
  BeamModel beams_;
  GlobalSearch search_;
  RecentScans recent_;
  std::vector<geometry::Pose> candidates_;  ///< that it has found, the best last
  geometry::Pose moved_since_search_;       ///< since the scan that is looked for
  ScanMotion motion_;
  std::vector<Hypothesis> hypotheses_;  ///< likeliest first
  std::optional<laser::Scan> last_scan_;
  std::optional<geometry::Pose> odom_;
  double moved_ = 0;         ///< since evidence was last counted; 1 m or 2 rad are 1
  int unlike_scans_ = 0;     ///< in a row that show another place
  int uncounted_ = 0;        ///< scans since then
  int stood_ = 0;            ///< times it was counted while it stood
  double since_search_ = 0;  ///< likewise, since poses everywhere were last tried
  double since_jump_m_ = 0;  ///< way since another hypothesis became the likeliest
  bool is_anywhere_ = false;
  bool was_tracked_ = false;
  bool is_followed_ = false;  ///< sure, and each scan has shown what the one before did
  bool is_told_ = false;      ///< where it is, by a person or a launch
  int sure_scans_ = 0;        ///< in a row
  double usual_ = 0.7;        ///< share of a scan that is explained while it is tracked
  int searches_ = 0;          ///< since it began, or became unsure
  int scans_since_search_ = 0;
  int badly_explained_ = 0;  ///< scans in a row
};

}  // namespace tocsin::localisation
