// SPDX-License-Identifier: Apache-2.0
#include "localisation/distance_map.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::localisation {
namespace {

constexpr double far_cells = 1e9;

/// Lower envelope of parabolas: squared distances in cells along one line.
class LineTransform {
 public:
  explicit LineTransform(std::size_t most) : at_(most), border_(most + 1), result_(most) {}

  const std::vector<double>& run(const std::vector<double>& squares, int count) {
    int last = 0;
    at_[0] = 0;
    border_[0] = -infinity;
    border_[1] = infinity;
    for (int q = 1; q < count; ++q) {
      double meet = meeting(squares, q, at_[index(last)]);
      while (meet <= border_[index(last)]) meet = meeting(squares, q, at_[index(--last)]);
      at_[index(++last)] = q;
      border_[index(last)] = meet;
      border_[index(last + 1)] = infinity;
    }
    for (int q = 0, k = 0; q < count; ++q) {
      while (border_[index(k + 1)] < q) ++k;
      const double away = q - at_[index(k)];
      result_[index(q)] = away * away + squares[index(at_[index(k)])];
    }
    return result_;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static double meeting(const std::vector<double>& squares, int q, int v) {
    return ((squares[index(q)] + double(q) * q) - (squares[index(v)] + double(v) * v)) /
           (2.0 * (q - v));
  }
  std::vector<int> at_;
  std::vector<double> border_;
  std::vector<double> result_;
};

}  // namespace

DistanceMap::DistanceMap(const navigation::OccupancyMap& map) : grid_(map.grid()) {
  const auto width = static_cast<std::size_t>(grid_.width);
  const auto height = static_cast<std::size_t>(grid_.height);
  std::vector<double> squares(grid_.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = map.cells()[i] == navigation::Cell::occupied ? 0 : far_cells;
  }
  LineTransform transform(std::max(width, height));
  std::vector<double> line(std::max(width, height));
  for (std::size_t column = 0; column < width; ++column) {
    for (std::size_t row = 0; row < height; ++row) line[row] = squares[row * width + column];
    const auto& result = transform.run(line, grid_.height);
    for (std::size_t row = 0; row < height; ++row) squares[row * width + column] = result[row];
  }
  distances_m_.resize(squares.size());
  for (std::size_t row = 0; row < height; ++row) {
    std::copy_n(squares.begin() + static_cast<std::ptrdiff_t>(row * width), width, line.begin());
    const auto& result = transform.run(line, grid_.width);
    for (std::size_t column = 0; column < width; ++column) {
      const double away_m = std::sqrt(result[column]) * grid_.resolution_m;
      distances_m_[row * width + column] = static_cast<float>(std::min(away_m, most_m));
    }
  }
}

DistanceMap::Sample DistanceMap::sample(const geometry::Point& p) const {
  const double column = (p.x_m - grid_.origin.x_m) / grid_.resolution_m - 0.5;
  const double row = (p.y_m - grid_.origin.y_m) / grid_.resolution_m - 0.5;
  if (!(column >= 0 && row >= 0 && column < grid_.width - 1 && row < grid_.height - 1)) return {};
  const int c = static_cast<int>(column);
  const int r = static_cast<int>(row);
  const double u = column - c;
  const double v = row - r;
  const std::size_t at = grid_.offset({c, r});
  const std::size_t above = at + static_cast<std::size_t>(grid_.width);
  const double d00 = distances_m_[at], d10 = distances_m_[at + 1];
  const double d01 = distances_m_[above], d11 = distances_m_[above + 1];
  return {(1 - v) * ((1 - u) * d00 + u * d10) + v * ((1 - u) * d01 + u * d11),
          ((1 - v) * (d10 - d00) + v * (d11 - d01)) / grid_.resolution_m,
          ((1 - u) * (d01 - d00) + u * (d11 - d10)) / grid_.resolution_m};
}

double DistanceMap::nearest_m(const geometry::Point& p) const {
  const auto cell = grid_.cell_of(p);
  return cell ? distances_m_[grid_.offset(*cell)] : most_m;
}

}  // namespace tocsin::localisation
