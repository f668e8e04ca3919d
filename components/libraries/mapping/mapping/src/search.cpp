// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mapping/scan_matcher.hpp"

namespace tocsin::mapping {
namespace {

using geometry::Pose;

using navigation::CellIndex;

/// Poses that share a heading and lie in a square of 2^level cells, the corner's lowest.
struct Node {
  int heading;  // index
  int level;
  CellIndex offset;  // from the guess
  double bound;      // no pose of it has a better score
};

class Search {
 public:
  Search(const FieldBounds& bounds, const Points& points, const Pose& guess,
         const SearchWindow& window, const SearchParams& params)
      : bounds_(bounds),
        points_(points),
        guess_(guess),
        window_(window),
        params_(params),
        resolution_m_(bounds.grid().resolution_m),
        reach_(static_cast<int>(std::ceil(window.distance_m / resolution_m_))),
        best_score_(params.min_score) {}

  std::optional<Match> run() {
    if (points_.empty() || bounds_.grid().width == 0) return std::nullopt;
    place_points();
    branch(roots());
    if (!found_) return std::nullopt;
    Match match;
    match.pose = pose_of(best_);
    match.score = best_score_;
    return match;
  }

 private:
  [[nodiscard]] double turn_of(int heading) const { return (heading - headings_) * step_rad_; }

  [[nodiscard]] Pose pose_of(const Node& node) const {
    return {guess_.x_m + node.offset.column * resolution_m_,
            guess_.y_m + node.offset.row * resolution_m_,
            geometry::wrap_angle(guess_.heading_rad + turn_of(node.heading))};
  }

  /// The cells of all points for each heading, at the guess.
  void place_points() {
    double reach_m = 1;
    for (const auto& p : points_) reach_m = std::max(reach_m, std::hypot(p.x_m, p.y_m));
    if (params_.resolved_range_m > 0) reach_m = std::min(reach_m, params_.resolved_range_m);
    step_rad_ = resolution_m_ / reach_m;
    headings_ = static_cast<int>(std::ceil(window_.turn_rad / step_rad_));
    const auto& origin = bounds_.grid().origin;
    placed_.resize(static_cast<std::size_t>(2 * headings_ + 1) * points_.size());
    auto* cell = placed_.data();
    for (int heading = 0; heading <= 2 * headings_; ++heading) {
      const double angle_rad = guess_.heading_rad + turn_of(heading);
      const double c = std::cos(angle_rad) / resolution_m_;
      const double s = std::sin(angle_rad) / resolution_m_;
      // One is added and taken off so that the cast rounds down also below 0.
      const double x = (guess_.x_m - origin.x_m) / resolution_m_ + lift;
      const double y = (guess_.y_m - origin.y_m) / resolution_m_ + lift;
      for (const auto& p : points_) {
        *cell++ = {static_cast<int>(x + c * p.x_m - s * p.y_m) - lift,
                   static_cast<int>(y + s * p.x_m + c * p.y_m) - lift};
      }
    }
  }

  /// Squared distance from the guess, in windows, of the nearest pose of a node.
  [[nodiscard]] double distance_from_guess(const Node& node) const {
    const int side = (1 << node.level) - 1;
    const auto nearest = [&](int low) { return std::max({low, 0, -(low + side)}); };
    const double dx = nearest(node.offset.column) * resolution_m_ / window_.distance_m;
    const double dy = nearest(node.offset.row) * resolution_m_ / window_.distance_m;
    const double turn = turn_of(node.heading) / window_.turn_rad;
    return dx * dx + dy * dy + turn * turn;
  }

  /// Not more than `best_score_` when no pose of the node is better.
  [[nodiscard]] double bound_of(const Node& node) const {
    const double off =
        params_.guess_weight > 0 ? params_.guess_weight * distance_from_guess(node) : 0;
    const double whole = 255.0 * static_cast<double>(points_.size());
    const CellIndex* const cells =
        &placed_[static_cast<std::size_t>(node.heading) * points_.size()];
    const int needed = static_cast<int>(whole * (best_score_ + off));
    return bounds_.sum(node.level, cells, points_.size(), node.offset, needed) / whole - off;
  }

  [[nodiscard]] bool is_excluded(const Node& leaf) const {
    if (!params_.excluded) return false;
    const Pose pose = pose_of(leaf);
    return geometry::distance(position(pose), position(*params_.excluded)) <
               params_.excluded_window.distance_m &&
           std::abs(geometry::wrap_angle(pose.heading_rad - params_.excluded->heading_rad)) <
               params_.excluded_window.turn_rad;
  }

  static void sort_best_first(std::vector<Node>& nodes) {
    std::stable_sort(nodes.begin(), nodes.end(),
                     [](const Node& a, const Node& b) { return a.bound > b.bound; });
  }

  [[nodiscard]] std::vector<Node> roots() const {
    int level = 0;
    while (level + 1 < FieldBounds::levels && (1 << level) < reach_) ++level;
    std::vector<Node> nodes;
    for (int heading = 0; heading <= 2 * headings_; ++heading) {
      for (int row = -reach_; row <= reach_; row += 1 << level) {
        for (int column = -reach_; column <= reach_; column += 1 << level) {
          Node node{heading, level, {column, row}, 0};
          node.bound = bound_of(node);
          if (node.bound > best_score_) nodes.push_back(node);
        }
      }
    }
    sort_best_first(nodes);
    return nodes;
  }

  void branch(const std::vector<Node>& nodes) {
    for (const Node& node : nodes) {
      if (node.bound <= best_score_) return;
      if (node.level > 0) {
        branch(children(node));
      } else if (!is_excluded(node)) {
        found_ = true;
        best_ = node;
        best_score_ = node.bound;
      }
    }
  }

  [[nodiscard]] std::vector<Node> children(const Node& node) const {
    const int half = 1 << (node.level - 1);
    std::vector<Node> nodes;
    for (const CellIndex step :
         {CellIndex{0, 0}, CellIndex{half, 0}, CellIndex{0, half}, CellIndex{half, half}}) {
      Node child{node.heading,
                 node.level - 1,
                 {node.offset.column + step.column, node.offset.row + step.row},
                 0};
      if (child.offset.column > reach_ || child.offset.row > reach_) continue;
      child.bound = bound_of(child);
      if (child.bound > best_score_) nodes.push_back(child);
    }
    sort_best_first(nodes);
    return nodes;
  }

  static constexpr int lift = 1 << 20;  // more cells than any field has
  const FieldBounds& bounds_;
  const Points& points_;
  const Pose& guess_;
  const SearchWindow& window_;
  const SearchParams& params_;
  double resolution_m_;
  int reach_;         // cells from the guess to the border of the window
  int headings_ = 0;  // on each side of the guess
  double step_rad_ = 0;
  std::vector<CellIndex> placed_;
  bool found_ = false;
  double best_score_;
  Node best_{};
};

}  // namespace

std::optional<Match> search(const FieldBounds& bounds, const Points& points,
                            const geometry::Pose& guess, const SearchWindow& window,
                            const SearchParams& params) {
  return Search(bounds, points, guess, window, params).run();
}

}  // namespace tocsin::mapping
