// SPDX-License-Identifier: Apache-2.0
#include "coverage/swaths.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;

/// A plane turned so that swaths lie along u.
class Turned {
 public:
  explicit Turned(double direction_rad)
      : cos_(std::cos(direction_rad)), sin_(std::sin(direction_rad)) {}
  [[nodiscard]] double u(const Point& p) const { return cos_ * p.x_m + sin_ * p.y_m; }
  [[nodiscard]] double v(const Point& p) const { return cos_ * p.y_m - sin_ * p.x_m; }
  [[nodiscard]] Point point(double u, double v) const {
    return {cos_ * u - sin_ * v, sin_ * u + cos_ * v};
  }

 private:
  double cos_;
  double sin_;
};

struct Extent {
  double low = infinity;
  double high = -infinity;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// A piece of a line, and the cell that it belongs to.
struct Piece {
  Extent u;
  std::size_t cell = 0;
};
using Line = std::vector<Piece>;

Line pieces_of(const Mask& mask, const Turned& turned, double v, const Extent& u) {
  Line line;
  bool was_in = false;
  const double step = mask.grid.resolution_m / 2;
  for (double at = u.low; at <= u.high; at += step) {
    const bool is_in = mask.has(turned.point(at, v));
    if (is_in && !was_in) line.push_back({});
    if (is_in) line.back().u.add(at);
    was_in = is_in;
  }
  return line;
}

std::vector<const Piece*> beside(const Line& line, const Piece& piece) {
  std::vector<const Piece*> found;
  for (const Piece& other : line) {
    if (other.u.low <= piece.u.high && other.u.high >= piece.u.low) found.push_back(&other);
  }
  return found;
}

/// The cell of the piece before it, when they are each other's only neighbours.
const Piece* predecessor(const Line& before, const Line& line, const Piece& piece) {
  const auto behind = beside(before, piece);
  if (behind.size() != 1 || beside(line, *behind.front()).size() != 1) return nullptr;
  return behind.front();
}

}  // namespace

double length_m(const Swath& swath) { return distance(swath.from, swath.to); }

std::size_t swaths_in(const std::vector<SwathCell>& cells) {
  std::size_t sum = 0;
  for (const SwathCell& cell : cells) sum += cell.size();
  return sum;
}

Pattern fitted(const Mask& mask, const Pattern& pattern, double inset_m) {
  const Turned turned(pattern.direction_rad);
  Extent v;
  for (const Point& p : mask.points()) v.add(turned.v(p));
  const double width_m = v.high - v.low - 2 * inset_m;
  if (!(width_m > 0)) return {pattern.direction_rad, pattern.spacing_m, (v.high - v.low) / 2};
  const double gaps = std::ceil(width_m / pattern.spacing_m);
  return {pattern.direction_rad, width_m / gaps, inset_m};
}

std::vector<SwathCell> swath_cells(const Mask& mask, const Pattern& pattern) {
  const Turned turned(pattern.direction_rad);
  Extent u;
  Extent v;
  for (const Point& p : mask.points()) {
    u.add(turned.u(p));
    v.add(turned.v(p));
  }
  std::vector<SwathCell> cells;
  Line before;
  for (double at = v.low + pattern.first_m; at <= v.high + 1e-9; at += pattern.spacing_m) {
    Line line = pieces_of(mask, turned, at, u);
    for (Piece& piece : line) {
      const Piece* const last = predecessor(before, line, piece);
      piece.cell = last != nullptr ? last->cell : cells.size();
      if (last == nullptr) cells.emplace_back();
      cells[piece.cell].push_back({turned.point(piece.u.low, at), turned.point(piece.u.high, at)});
    }
    before = std::move(line);
  }
  return cells;
}

}  // namespace tocsin::coverage
