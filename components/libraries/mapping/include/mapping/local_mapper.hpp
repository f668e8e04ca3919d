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
};

/// Scan to submap: a trajectory without jumps that drifts. Two submaps grow at a time, the younger
/// one half as old, so that each scan meets a submap that has something to match.
class LocalMapper {
 public:
  /// A scan that was used.
  struct Node {
    geometry::Pose odometry;
    geometry::Pose pose;  ///< in the frame of the first odometry; drifts
    Scan scan;
    Points thin;           ///< its hits, thinned
    bool matched = false;  ///< odometry alone when not
  };

  explicit LocalMapper(const LocalParams& params = {});

  /// Takes a scan; returns the constraints of the node that it became, nothing when the vehicle has
  /// not moved enough since the last one.
  std::optional<std::vector<Constraint>> on_scan(const geometry::Pose& odometry, Scan scan);
  /// Finishes the submaps that still grow: the log has ended.
  void finish();

  /// Makes all submaps anew, their scans at these poses (one for each node).
  void rebuild(const std::vector<geometry::Pose>& poses);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// All submaps in the order of their first nodes; the last two may still grow.
  [[nodiscard]] const std::deque<Submap>& submaps() const { return submaps_; }
  /// Where the vehicle is at that odometry, in the frame of the nodes' poses.
  [[nodiscard]] geometry::Pose pose_at(const geometry::Pose& odometry) const;

 private:
  [[nodiscard]] bool has_moved(const geometry::Pose& odometry) const;
  [[nodiscard]] Match match(const Submap& submap, const Node& node,
                            const geometry::Pose& step) const;
  void place(Node& node, std::vector<Constraint>& constraints);
  void insert(const Node& node);
  /// The oldest submap that grows.
  [[nodiscard]] const Submap& target() const;
  [[nodiscard]] geometry::Pose in_submap(const Submap& submap, const geometry::Pose& pose) const;

  LocalParams params_;
  OdometryModel odometry_;
  std::vector<Node> nodes_;
  std::deque<Submap> submaps_;
};

}  // namespace tocsin::mapping
