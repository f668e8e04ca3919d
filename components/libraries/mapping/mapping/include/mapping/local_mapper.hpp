// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "mapping/odometry_model.hpp"
#include "mapping/pose_graph.hpp"
#include "mapping/submap.hpp"

namespace tocsin::mapping {

struct LocalParams {
  double resolution_m = 0.05;
  double sigma_m = 0.05;          ///< how far a reading may lie from a wall that it belongs to
  double step_m = 0.1;            ///< a scan is used when the vehicle has moved so far,
  double step_rad = 0.1;          ///< or turned so much
  std::size_t submap_scans = 20;  ///< of a finished submap; the next one begins at its half
  double thin_m = 0.1;            ///< readings nearer to each other than this count once
  double min_score = 0.3;         ///< worse is no match: odometry decides
  double guess_weight = 0.05;     ///< of SearchParams
  double sure_score = 0.6;        ///< what fits so well near its guess is not searched for
};

/// What became of a scan that was used. Its place among all such scans is its node's index.
struct LocalStep {
  geometry::Pose odometry;
  geometry::Pose pose;  ///< without jumps; drifts
  Scan scan;
  bool matched = false;                 ///< odometry alone when not
  std::vector<Constraint> constraints;  ///< of this node to earlier ones
  std::vector<Submap> finished;         ///< by this scan
};

/// Scan to submap: a trajectory without jumps that drifts. Two submaps grow at a time, the younger
/// one half as old, so that each scan meets a submap that has something to match. Keeps nothing of
/// what is finished: its memory and time do not grow with the drive.
class LocalMapper {
 public:
  /// Begins at `start`, in the frame of the poses, with node `first_node`. Without a start that is
  /// where the odometry is.
  explicit LocalMapper(const LocalParams& params = {}, std::optional<geometry::Pose> start = {},
                       std::size_t first_node = 0);

  /// Takes a scan; nothing when the vehicle has not moved enough since the last one.
  std::optional<LocalStep> on_scan(const geometry::Pose& odometry, Scan scan);
  /// The submaps that still grow, finished: the log has ended.
  std::vector<Submap> finish();
  /// The odometry counts anew: a vehicle that it had at `before` it has at `now`.
  void on_new_odometry(const geometry::Pose& before, const geometry::Pose& now);

  /// Where the vehicle is at that odometry, in the frame of the poses.
  [[nodiscard]] geometry::Pose pose_at(const geometry::Pose& odometry) const;

 private:
  struct Growing {
    geometry::Pose first;  ///< pose of its first node
    Submap submap;
  };
  struct Last {
    geometry::Pose odometry;
    geometry::Pose pose;
  };
  [[nodiscard]] bool has_moved(const geometry::Pose& odometry) const;
  [[nodiscard]] Match match(const Growing& target, const Points& thin, const geometry::Pose& pose,
                            const geometry::Pose& step) const;
  void place(LocalStep& node);
  void insert(LocalStep& node);

  LocalParams params_;
  OdometryModel odometry_;
  std::optional<geometry::Pose> start_;
  std::size_t next_node_;
  std::optional<Last> last_;
  std::deque<Growing> growing_;  ///< the oldest first
};

}  // namespace tocsin::mapping
