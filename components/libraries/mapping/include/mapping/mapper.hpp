// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mapping/local_mapper.hpp"
#include "mapping/loop_finder.hpp"
#include "mapping/pose_graph.hpp"

namespace tocsin::mapping {

struct MapperParams {
  LocalParams local;
  LoopParams loop;
  double near_m = 4.0;              ///< submaps with a node so near are matched with every scan,
  std::size_t most_near = 2;        ///< the nearest ones while driving,
  std::size_t most_near_again = 8;  ///< and in each pass of finish
  int passes = 2;                   ///< of finish
  double near_window_m = 0.3;  ///< how far the graph may be off there, besides what the way adds
  double near_min_score = 0.45;
  double drift_share = 0.03;  ///< of the way through the graph: how far loops are looked for
  double sure_way_m = 15.0;   ///< up to this way through the graph a submap is near, not a loop
  double largest_window_m = 8.0;
  double loop_reach_m = 8.0;  ///< a loop is looked for in submaps with a node so near, window added
  std::size_t loop_every = 4;    ///< nodes between two looks for loops
  double loop_thin_m = 0.25;     ///< readings nearer to each other than this count once
  std::size_t loop_nodes = 8;    ///< whose readings are looked for together
  std::size_t solve_every = 20;  ///< nodes between two solves without a loop
};

/// Simultaneous localisation and mapping with a laser in the plane: odometry and scans in, the
/// poses of the scans that were used and a map out. Deterministic: the same input gives the same
/// output, bit for bit, on the same machine.
///
/// Pure: no clock, thread or file. Not thread-safe.
class Mapper {
 public:
  explicit Mapper(const MapperParams& params = {});

  /// Takes a scan of the vehicle at `odometry` (the frame in which the wheels count). Both must be
  /// finite. Returns whether it was used: the vehicle must have moved since the last one.
  bool on_scan(const geometry::Pose& odometry, Scan scan);
  /// The log has ended: places that were seen twice are matched once more, all with all.
  void finish();

  /// Where the vehicle is on the map; `odometry` must be near that of the last scan.
  [[nodiscard]] geometry::Pose pose_at(const geometry::Pose& odometry) const;
  /// The scans that were used, and where they are by the local matching.
  [[nodiscard]] const std::vector<LocalMapper::Node>& nodes() const { return local_.nodes(); }
  /// Where they are on the map.
  [[nodiscard]] const std::vector<geometry::Pose>& poses() const { return graph_.poses(); }
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  [[nodiscard]] const LocalMapper& local() const { return local_; }
  /// Loops that were found and agreed with another one.
  [[nodiscard]] std::size_t loops() const { return loops_; }
  /// All scans on one grid, at where they are now.
  [[nodiscard]] navigation::OccupancyMap map(double resolution_m) const;

 private:
  [[nodiscard]] std::vector<double> ways_from(std::size_t node) const;
  [[nodiscard]] double distance_to(const Submap& submap, std::size_t node) const;
  [[nodiscard]] Points recent_points(std::size_t node) const;
  /// The finished submaps that a node is matched with, which its own are not; indices.
  [[nodiscard]] std::vector<std::size_t> near_submaps(std::size_t node,
                                                      const std::vector<double>& ways,
                                                      std::size_t most) const;
  void match_near(std::size_t node, const std::vector<double>& ways);
  /// Adds the constraint of a scan that lies well in the submap at `start`.
  void add_near(const Submap& submap, std::size_t node, const geometry::Pose& start);
  /// One pass of finish.
  void match_all_again();
  bool look_for_loops(std::size_t node, const std::vector<double>& ways);
  [[nodiscard]] bool accept(const LoopCandidate& candidate);

  MapperParams params_;
  LocalMapper local_;
  PoseGraph graph_;
  LoopJury jury_;
  std::size_t loops_ = 0;
  std::size_t solved_at_ = 0;  // number of nodes
};

}  // namespace tocsin::mapping
