// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mapping/local_mapper.hpp"
#include "mapping/loop_finder.hpp"
#include "mapping/packed_scan.hpp"
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
  std::size_t most_awake = 12;   ///< finished submaps whose fields are kept in memory
};

/// A map that was made before, or that is to be kept: all that another GlobalMapper needs to go on.
struct MapSession {
  struct Node {
    geometry::Pose pose;  ///< on the map
    PackedScan scan;
  };
  std::vector<Node> nodes;
  std::vector<std::vector<std::size_t>> submaps;  ///< nodes of each finished one, rising
  std::vector<Constraint> constraints;
};

/// Joins what a LocalMapper makes into one map: recognises places, and moves the nodes so that all
/// agree. May take long: its owner calls it beside the matching. Deterministic. Not thread-safe.
class GlobalMapper {
 public:
  /// A scan that was used.
  struct Node {
    geometry::Pose odometry;
    geometry::Pose pose;  ///< by the local matching; drifts
    PackedScan scan;
    bool matched = false;  ///< odometry alone when not
  };

  explicit GlobalMapper(const MapperParams& params = {});
  /// Goes on with a session. Asserts that its indices fit.
  GlobalMapper(const MapperParams& params, MapSession session);

  /// Takes what a scan became. Asserts that it is the next node.
  void add(LocalStep step);
  /// The log has ended: takes the submaps that still grew, and matches all with all once more.
  void finish(std::vector<Submap> last);

  /// Where `scan` was taken, by the submaps within `reach_m` of `guess`; empty when none has it
  /// within `window` of there.
  [[nodiscard]] std::optional<geometry::Pose> locate(const Scan& scan, const geometry::Pose& guess,
                                                     double reach_m,
                                                     const SearchWindow& window) const;

  /// The scans that were used, and where they are by the local matching.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Where they are on the map.
  [[nodiscard]] const std::vector<geometry::Pose>& poses() const { return graph_.poses(); }
  [[nodiscard]] const PoseGraph& graph() const { return graph_; }
  /// The finished ones in the order of their first nodes.
  [[nodiscard]] const std::deque<Submap>& submaps() const { return submaps_; }
  /// Loops that were found and agreed with another one.
  [[nodiscard]] std::size_t loops() const { return loops_; }
  [[nodiscard]] MapSession session() const;

 private:
  [[nodiscard]] Constraint anchor_of(std::size_t node) const;
  [[nodiscard]] std::vector<double> ways_from(std::size_t node) const;
  [[nodiscard]] double distance_to(const Submap& submap, const geometry::Pose& pose) const;
  [[nodiscard]] Points thin(std::size_t node) const;
  [[nodiscard]] Points recent_points(std::size_t node) const;
  /// The finished submaps that a node is matched with, which its own are not; indices.
  [[nodiscard]] std::vector<std::size_t> near_submaps(std::size_t node,
                                                      const std::vector<double>& ways,
                                                      std::size_t most) const;
  void match_near(std::size_t node, const std::vector<double>& ways);
  /// Adds the constraint of a scan that lies well in the submap at `start`.
  void add_near(const Submap& submap, std::size_t node, const Points& points, const Match& match);
  /// One pass of finish.
  void match_all_again();
  void rebuild();
  bool look_for_loops(std::size_t node, const std::vector<double>& ways);
  [[nodiscard]] bool accept(const LoopCandidate& candidate);
  /// The submap; puts the one to rest that was not used for longest.
  [[nodiscard]] const Submap& awake(std::size_t index) const;

  MapperParams params_;
  std::vector<Node> nodes_;
  std::deque<Submap> submaps_;
  mutable std::deque<std::size_t> awake_;  ///< the last used last
  PoseGraph graph_;
  LoopJury jury_;
  std::size_t loops_ = 0;
  std::size_t solved_at_ = 0;  // number of nodes
};

}  // namespace tocsin::mapping
