// SPDX-License-Identifier: Apache-2.0
#include "mapping/likelihood_field.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::mapping {
namespace {

using geometry::Point;

constexpr int places = LikelihoodField::places;
constexpr int field_margin = 64;    // by which a field that must grow grows more than it must
constexpr double kernel_reach = 3;  // [sigma]

std::vector<std::uint8_t> kernel(int reach, double x_cells, double y_cells, double sigma_cells) {
  std::vector<std::uint8_t> values;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double dx = (column + 0.5 - x_cells) / sigma_cells;
      const double dy = (row + 0.5 - y_cells) / sigma_cells;
      values.push_back(
          static_cast<std::uint8_t>(std::lround(255 * std::exp(-0.5 * (dx * dx + dy * dy)))));
    }
  }
  return values;
}

std::size_t index(int width, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

}  // namespace

LikelihoodField::LikelihoodField(double resolution_m, double sigma_m)
    : sigma_m_(sigma_m),
      reach_(static_cast<int>(std::ceil(kernel_reach * sigma_m / resolution_m))) {
  grid_.resolution_m = resolution_m;
  for (int y = 0; y < places; ++y) {
    for (int x = 0; x < places; ++x) {
      kernels_.push_back(
          kernel(reach_, (x + 0.5) / places, (y + 0.5) / places, sigma_m / resolution_m));
    }
  }
}

void LikelihoodField::cover(const Points& points) {
  const double r = grid_.resolution_m;
  double low_x = grid_.width > 0 ? 0 : infinity;
  double low_y = low_x;
  double high_x = grid_.width > 0 ? grid_.width - 1 : -infinity;
  double high_y = grid_.width > 0 ? grid_.height - 1 : -infinity;
  bool fits = grid_.width > 0;
  for (const Point& p : points) {
    const double column = std::floor((p.x_m - grid_.origin.x_m) / r);
    const double row = std::floor((p.y_m - grid_.origin.y_m) / r);
    fits = fits && column - reach_ >= 0 && row - reach_ >= 0 && column + reach_ < grid_.width &&
           row + reach_ < grid_.height;
    low_x = std::min(low_x, column - reach_ - field_margin);
    low_y = std::min(low_y, row - reach_ - field_margin);
    high_x = std::max(high_x, column + reach_ + field_margin);
    high_y = std::max(high_y, row + reach_ + field_margin);
  }
  if (fits || points.empty()) return;
  navigation::Grid grown = grid_;
  grown.width = static_cast<int>(high_x - low_x) + 1;
  grown.height = static_cast<int>(high_y - low_y) + 1;
  grown.origin = {grid_.origin.x_m + low_x * r, grid_.origin.y_m + low_y * r};
  std::vector<std::uint8_t> cells(grown.size());
  for (int row = 0; row < grid_.height; ++row) {
    const auto first = cells_.begin() + static_cast<std::ptrdiff_t>(grid_.offset({0, row}));
    const std::size_t to =
        index(grown.width, -static_cast<int>(low_x), row - static_cast<int>(low_y));
    std::copy(first, first + grid_.width, cells.begin() + static_cast<std::ptrdiff_t>(to));
  }
  cells_ = std::move(cells);
  grid_ = grown;
}

void LikelihoodField::stamp(const Point& p) {
  const double x = (p.x_m - grid_.origin.x_m) / grid_.resolution_m;
  const double y = (p.y_m - grid_.origin.y_m) / grid_.resolution_m;
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const int place =
      static_cast<int>((y - row) * places) * places + static_cast<int>((x - column) * places);
  const std::uint8_t* from = kernels_[static_cast<std::size_t>(place)].data();
  const int side = 2 * reach_ + 1;
  for (int i = 0; i < side; ++i, from += side) {
    std::uint8_t* const to = &cells_[index(grid_.width, column - reach_, row - reach_ + i)];
    for (int j = 0; j < side; ++j) to[j] = std::max(to[j], from[j]);
  }
}

void LikelihoodField::stamp(const Points& points) {
  cover(points);
  for (const Point& p : points) stamp(p);
}

std::optional<LikelihoodField::Between> LikelihoodField::between(double x_m, double y_m,
                                                                 int border) const {
  const double x = (x_m - grid_.origin.x_m) / grid_.resolution_m - 0.5;
  const double y = (y_m - grid_.origin.y_m) / grid_.resolution_m - 0.5;
  const bool is_inside =
      x >= border && y >= border && x < grid_.width - 1 - border && y < grid_.height - 1 - border;
  if (!is_inside) return std::nullopt;  // nor is what is no number
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  return Between{column, row, x - column, y - row};
}

LikelihoodField::Curvature LikelihoodField::curvature_at(double x_m, double y_m) const {
  const int step = std::max(1, static_cast<int>(std::lround(sigma_m_ / grid_.resolution_m)));
  const auto place = between(x_m, y_m, step);
  if (!place) return {};
  const int up = step * grid_.width;
  const std::uint8_t* const corner = &cells_[index(grid_.width, place->column, place->row)];
  // The differences of the interpolated values are interpolated differences of the cells.
  const auto mix = [&](const auto& difference) {
    const double below = difference(corner);
    const double above = difference(corner + grid_.width);
    const double low = below + place->u * (difference(corner + 1) - below);
    const double high = above + place->u * (difference(corner + grid_.width + 1) - above);
    return low + place->v * (high - low);
  };
  const double h = step * grid_.resolution_m;
  const double scale = 1 / (255 * h * h);
  return {scale * mix([&](const auto* c) { return c[step] - 2 * c[0] + c[-step]; }),
          scale / 4 * mix([&](const auto* c) {
            return c[up + step] - c[up - step] - c[step - up] + c[-step - up];
          }),
          scale * mix([&](const auto* c) { return c[up] - 2 * c[0] + c[-up]; })};
}

LikelihoodField::Sample LikelihoodField::at(double x_m, double y_m) const {
  const auto place = between(x_m, y_m, 0);
  if (!place) return {};
  const auto [column, row, u, v] = *place;
  const std::uint8_t* const below = &cells_[index(grid_.width, column, row)];
  const std::uint8_t* const above = below + grid_.width;
  const double left = below[0] + v * (above[0] - below[0]);
  const double right = below[1] + v * (above[1] - below[1]);
  const double low = below[0] + u * (below[1] - below[0]);
  const double high = above[0] + u * (above[1] - above[0]);
  const double per_m = 1 / (255 * grid_.resolution_m);
  return {(left + u * (right - left)) / 255, (right - left) * per_m, (high - low) * per_m};
}

FieldBounds::FieldBounds(const LikelihoodField& field) : grid_(&field.grid()) {
  Level finest;
  finest.width = grid_->width;
  finest.height = grid_->height;
  finest.cells = field.cells().data();
  levels_.push_back(finest);
  Level pool = finest;
  for (int i = 1; i < levels; ++i) {
    pool = pooled(pool);
    levels_.push_back(widened(pool));
  }
  for (std::size_t i = 1; i < levels_.size(); ++i) levels_[i].cells = levels_[i].own.data();
}

int FieldBounds::sum(int level, const navigation::CellIndex* cells, std::size_t count,
                     navigation::CellIndex offset, int needed) const {
  constexpr std::size_t stretch = 32;  // cells between two looks at what is left
  const Level& l = levels_[static_cast<std::size_t>(level)];
  const int column = offset.column + (l.border << level);
  const int row = offset.row + (l.border << level);
  int sum = 0;
  for (std::size_t begin = 0; begin < count; begin += stretch) {
    if (sum + 255 * static_cast<int>(count - begin) <= needed) return sum;
    const std::size_t end = std::min(begin + stretch, count);
    for (std::size_t i = begin; i < end; ++i) {
      const auto x = static_cast<unsigned>((cells[i].column + column) >> level);
      const auto y = static_cast<unsigned>((cells[i].row + row) >> level);
      if (x >= static_cast<unsigned>(l.width) || y >= static_cast<unsigned>(l.height)) continue;
      sum += l.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(l.width) + x];
    }
  }
  return sum;
}

FieldBounds::Level FieldBounds::pooled(const Level& finer) {
  Level pool;
  pool.width = (finer.width + 1) / 2;
  pool.height = (finer.height + 1) / 2;
  pool.own.resize(index(pool.width, 0, pool.height));
  for (int row = 0; row < pool.height; ++row) {
    const std::uint8_t* const low = finer.cells + index(finer.width, 0, 2 * row);
    const std::uint8_t* const high = 2 * row + 1 < finer.height ? low + finer.width : low;
    std::uint8_t* const to = &pool.own[index(pool.width, 0, row)];
    for (int column = 0; column < finer.width / 2; ++column) {
      to[column] = std::max(std::max(low[2 * column], low[2 * column + 1]),
                            std::max(high[2 * column], high[2 * column + 1]));
    }
    if (finer.width % 2 == 1) {
      to[pool.width - 1] = std::max(low[finer.width - 1], high[finer.width - 1]);
    }
  }
  pool.cells = pool.own.data();
  return pool;
}

FieldBounds::Level FieldBounds::widened(const Level& pool) {
  // A square and its neighbours on the right and above: what its cells can reach. One column and
  // one row more on the left and below, whose cells can reach the field, too.
  Level wide;
  wide.width = pool.width + 1;
  wide.height = pool.height + 1;
  wide.border = 1;
  wide.own.assign(index(wide.width, 0, wide.height), 0);
  for (int row = 0; row < pool.height; ++row) {
    const std::uint8_t* const from = pool.cells + index(pool.width, 0, row);
    for (const int to_row : {row, row + 1}) {
      std::uint8_t* const to = &wide.own[index(wide.width, 0, to_row)];
      for (int column = 0; column < pool.width; ++column) {
        to[column] = std::max(to[column], from[column]);
      }
      for (int column = 0; column < pool.width; ++column) {
        to[column + 1] = std::max(to[column + 1], from[column]);
      }
    }
  }
  return wide;
}

}  // namespace tocsin::mapping
