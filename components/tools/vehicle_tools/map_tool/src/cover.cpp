// SPDX-License-Identifier: Apache-2.0
#include "cover.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "navigation/map_loader.hpp"
#include "navigation/map_writer.hpp"
#include "navigation/mission_writer.hpp"

namespace tocsin::map_tool {
namespace {

using geometry::Point;

constexpr char path_grey = 80;
constexpr auto left_out_grey = static_cast<char>(160);

std::size_t pixel_of(const navigation::Grid& grid, navigation::CellIndex cell) {
  return grid.offset({cell.column, grid.height - 1 - cell.row});
}

void draw(const geometry::Path& path, const navigation::Grid& grid, char* pixels) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double way_m = distance(path[i - 1], path[i]);
    const int steps = 1 + static_cast<int>(way_m / grid.resolution_m);
    for (int k = 0; k <= steps; ++k) {
      const auto cell = grid.cell_of(between(path[i - 1], path[i], double(k) / steps));
      if (cell) pixels[pixel_of(grid, *cell)] = path_grey;
    }
  }
}

void write_picture(const CoverOptions& options, const std::string& picture) {
  const auto error = replace_file(options.picture, picture);
  if (error) throw ConfigError(options.picture + ": cannot be written: " + error.message());
}

navigation::Mission mission_of(const coverage::CoveragePlan& plan, const std::string& path) {
  navigation::Mission mission;
  mission.name = std::filesystem::path(path).stem().string();
  for (const coverage::Stop& stop : plan.stops) mission.waypoints.push_back({stop.pose});
  return mission;
}

}  // namespace

Point point_in(const std::string& text, const char* option) {
  Point point;
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, point.x_m);
  if (x.ec == std::errc() && x.ptr != end && *x.ptr == ',') {
    const auto y = std::from_chars(x.ptr + 1, end, point.y_m);
    if (y.ec == std::errc() && y.ptr == end && is_finite(point)) return point;
  }
  throw ConfigError(fmt::format("{}: '{}' is no place; X,Y in m is one, such as 1.5,-2", option,
                                text.substr(0, 40)));
}

std::string picture_of(const navigation::OccupancyMap& map, const coverage::CoveragePlan& plan) {
  const navigation::Grid& grid = map.grid();
  std::string image = navigation::pgm_of(map);
  char* const pixels = image.data() + image.size() - grid.size();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (plan.left_out.cells[grid.offset({column, row})] == 0) continue;
      pixels[pixel_of(grid, {column, row})] = left_out_grey;
    }
  }
  draw(plan.path, grid, pixels);
  return image;
}

std::string cover(const CoverOptions& options) {
  coverage::Area area{point_in(options.start, "--start"), {}};
  for (const std::string& corner : options.polygon) {
    area.polygon.push_back(point_in(corner, "--polygon"));
  }
  const auto map = navigation::load_map(options.map);
  const auto plan = plan_coverage(map, options.params, area);
  write_mission(mission_of(plan, options.mission), options.mission);
  if (!options.picture.empty()) write_picture(options, picture_of(map, plan));
  return fmt::format(
      "{:.1f} % of {:.1f} m2 that can be reached, on {:.0f} m: {:.2f} of area / width; {} swaths "
      "in "
      "{} cells, {} waypoints\n",
      100 * plan.share, plan.floor_m2, plan.length_m, plan.length_to_least, plan.swaths, plan.cells,
      plan.stops.size());
}

}  // namespace tocsin::map_tool
