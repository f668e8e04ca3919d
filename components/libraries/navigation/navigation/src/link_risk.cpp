// SPDX-License-Identifier: Apache-2.0
#include "navigation/link_risk.hpp"

#include <algorithm>
#include <cassert>

namespace tocsin::navigation {
namespace {

double share_of(std::int8_t percent) {
  return percent < 0 || percent > 100 ? 0.5 : percent / 100.0;
}

int cell_of(double from_origin_m, double resolution_m, int cells) {
  return static_cast<int>(std::clamp(from_origin_m / resolution_m, 0.0, cells - 1.0));
}

}  // namespace

LinkRisk::LinkRisk(const Grid& grid, std::vector<std::int8_t> percent) : grid_(grid) {
  assert(!percent.empty() && percent.size() == grid.size());
  risk_.resize(percent.size());
  std::transform(percent.begin(), percent.end(), risk_.begin(), share_of);
}

double LinkRisk::at(const geometry::Point& p) const {
  assert(is_finite(p));
  return risk_[grid_.offset({cell_of(p.x_m - grid_.origin.x_m, grid_.resolution_m, grid_.width),
                             cell_of(p.y_m - grid_.origin.y_m, grid_.resolution_m, grid_.height)})];
}

std::vector<float> LinkRisk::on(const Grid& grid) const {
  std::vector<std::size_t> columns;
  for (int column = 0; column < grid.width; ++column) {
    const double from_origin_m = grid.centre({column, 0}).x_m - grid_.origin.x_m;
    columns.push_back(
        static_cast<std::size_t>(cell_of(from_origin_m, grid_.resolution_m, grid_.width)));
  }
  std::vector<float> cells;
  cells.reserve(grid.size());
  for (int row = 0; row < grid.height; ++row) {
    const double from_origin_m = grid.centre({0, row}).y_m - grid_.origin.y_m;
    const double* const risks =
        &risk_[grid_.offset({0, cell_of(from_origin_m, grid_.resolution_m, grid_.height)})];
    for (const std::size_t column : columns) cells.push_back(static_cast<float>(risks[column]));
  }
  return cells;
}

double LinkRisk::silent_m(const geometry::Path& path) const {
  double sum = 0;
  walk(path, [&](double risk, double length_m) {
    sum += length_m * risk;
    return true;
  });
  return sum;
}

}  // namespace tocsin::navigation
