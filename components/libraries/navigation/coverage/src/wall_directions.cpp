// SPDX-License-Identifier: Apache-2.0
#include "wall_directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "foundation/numbers.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;
using navigation::CellIndex;

constexpr std::size_t bins = 90;      // of 2 degrees
constexpr int window = 16;            // cells around an edge cell that its direction is taken from
constexpr double least_slimness = 8;  // of the edge in a window: length to width, squared

struct Spread {
  double count = 0;
  Point mean;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  void add(const Point& p) {  // Welford
    ++count;
    const double dx = p.x_m - mean.x_m;
    const double dy = p.y_m - mean.y_m;
    mean = {mean.x_m + dx / count, mean.y_m + dy / count};
    xx += dx * (p.x_m - mean.x_m);
    xy += dx * (p.y_m - mean.y_m);
    yy += dy * (p.y_m - mean.y_m);
  }
  [[nodiscard]] double axis_rad() const { return 0.5 * std::atan2(2 * xy, xx - yy); }
  [[nodiscard]] bool is_slim() const {
    const double half = (xx + yy) / 2;
    const double apart = std::hypot((xx - yy) / 2, xy);
    return count >= window && half + apart > least_slimness * (half - apart);
  }
};

Mask edge_of(const Mask& mask) {
  Mask edge(mask.grid);
  const auto is_out = [&](int column, int row) {
    return !mask.grid.contains({column, row}) || mask.cells[mask.grid.offset({column, row})] == 0;
  };
  for (int row = 0; row < mask.grid.height; ++row) {
    for (int column = 0; column < mask.grid.width; ++column) {
      if (is_out(column, row)) continue;
      edge.cells[mask.grid.offset({column, row})] =
          is_out(column - 1, row) || is_out(column + 1, row) || is_out(column, row - 1) ||
          is_out(column, row + 1);
    }
  }
  return edge;
}

/// The direction of the edge at a cell [rad] [range 0,pi), where it is straight.
std::optional<double> direction_at(const Mask& edge, CellIndex at) {
  Spread spread;
  for (int row = at.row - window; row <= at.row + window; ++row) {
    for (int column = at.column - window; column <= at.column + window; ++column) {
      if (!edge.grid.contains({column, row})) continue;
      if (edge.cells[edge.grid.offset({column, row})] == 0) continue;
      spread.add({double(column), double(row)});
    }
  }
  if (!spread.is_slim()) return std::nullopt;
  const double axis_rad = spread.axis_rad();
  return axis_rad < 0 ? axis_rad + pi : axis_rad;
}

std::vector<double> directions_of(const Mask& edge) {
  std::vector<double> directions;
  for (int row = 0; row < edge.grid.height; ++row) {
    for (int column = 0; column < edge.grid.width; ++column) {
      if (edge.cells[edge.grid.offset({column, row})] == 0) continue;
      if (const auto direction = direction_at(edge, {column, row}))
        directions.push_back(*direction);
    }
  }
  return directions;
}

/// The difference of two directions of lines [rad] [range -pi/2,pi/2].
double between_lines(double a, double b) { return std::remainder(b - a, pi); }

/// The mean of all that are near to the middle of the fullest bin; takes them out.
double take_peak(std::vector<double>& directions) {
  std::array<std::size_t, bins> counts{};
  for (const double d : directions) ++counts[std::size_t(d / pi * bins) % bins];
  const auto fullest = std::max_element(counts.begin(), counts.end()) - counts.begin();
  double peak = (static_cast<double>(fullest) + 0.5) * pi / bins;
  for (int i = 0; i < 3; ++i) {
    double sum = 0;
    double count = 0;
    for (const double d : directions) {
      if (std::abs(between_lines(peak, d)) > 2 * pi / bins) continue;
      sum += between_lines(peak, d);
      ++count;
    }
    peak += count > 0 ? sum / count : 0;
  }
  const auto is_near = [&](double d) { return std::abs(between_lines(peak, d)) < 4 * pi / bins; };
  directions.erase(std::remove_if(directions.begin(), directions.end(), is_near), directions.end());
  return peak < 0 ? peak + pi : peak;
}

}  // namespace

double long_axis(const std::vector<Point>& points) {
  Spread spread;
  for (const Point& p : points) spread.add(p);
  return spread.axis_rad();
}

std::vector<double> wall_directions(const Mask& mask, std::size_t most) {
  auto directions = directions_of(edge_of(mask));
  const std::size_t least = directions.size() / 20;
  std::vector<double> peaks;
  while (peaks.size() < most && directions.size() > least) peaks.push_back(take_peak(directions));
  return peaks;
}

}  // namespace tocsin::coverage
