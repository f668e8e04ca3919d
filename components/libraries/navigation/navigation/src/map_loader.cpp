// SPDX-License-Identifier: Apache-2.0
#include "navigation/map_loader.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "foundation/parameters.hpp"
#include "foundation/read_file.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::navigation {
namespace {

constexpr std::size_t longest_image = std::size_t{1} << 27U;  // [byte]

struct MapFile {
  std::string image;
  std::string mode = "trinary";
  double resolution = 0;
  std::vector<double> origin;
  int negate = 0;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  template <class Visitor>
  void visit(Visitor& v) {
    v("image", image, "PGM file, relative to the YAML file");
    v("mode", mode, {"trinary"}, "how greys are read");
    v("resolution", resolution, {0.001, 10}, "[m] side of a cell");
    v("origin", origin, {-1e6, 1e6}, "[m, m, rad] pose of the lower left corner");
    v("negate", negate, {0, 1}, "1: black is free");
    v("occupied_thresh", occupied_thresh, {0, 1}, "[1] more black is occupied");
    v("free_thresh", free_thresh, {0, 1}, "[1] less black is free");
  }
};

void require(const YAML::Node& node, const char* key, const std::string& path) {
  if (!node[key]) throw ConfigError("map." + std::string(key) + ": missing (" + path + ")");
}

MapFile read_map_file(const std::string& path) {
  if (path.empty()) throw ConfigError("map_file: is empty; it is the path of a map's .yaml");
  const YAML::Node node = read_yaml_file(path);
  const auto file = load_parameters<MapFile>(node, "map", path);
  for (const char* key : {"image", "resolution", "origin"}) require(node, key, path);
  if (file.origin.size() != 3 || file.origin[2] != 0) {
    throw ConfigError("map.origin: must be [x, y, 0], a rotated map is not supported" +
                      yaml_place(path, node["origin"]));
  }
  if (file.free_thresh > file.occupied_thresh) {
    throw ConfigError("map.free_thresh: is above occupied_thresh (" + path + ")");
  }
  return file;
}

/// What each grey stands for.
std::array<Cell, 256> cells_of_greys(int max, const MapScale& scale) {
  std::array<Cell, 256> cells{};
  for (std::size_t grey = 0; grey < cells.size(); ++grey) {
    const double white = static_cast<double>(grey) / max;
    const double black = scale.negate ? white : 1 - white;
    cells[grey] = Cell::unknown;
    if (black > scale.occupied_thresh) cells[grey] = Cell::occupied;
    if (black < scale.free_thresh) cells[grey] = Cell::free;
  }
  return cells;
}

}  // namespace

OccupancyMap map_from_image(const GrayImage& image, const MapScale& scale) {
  const Grid grid{image.width, image.height, scale.resolution_m, scale.origin};
  const auto greys = cells_of_greys(image.max, scale);
  std::vector<Cell> cells(grid.size(), Cell::unknown);
  for (int row = 0; row < grid.height; ++row) {
    const std::size_t from_top = grid.offset({0, grid.height - 1 - row});
    const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(from_top);
    std::transform(first, first + grid.width,
                   cells.begin() + static_cast<std::ptrdiff_t>(grid.offset({0, row})),
                   [&](std::uint8_t grey) { return greys[grey]; });
  }
  return {grid, std::move(cells)};
}

namespace {

OccupancyMap read_map(const std::string& yaml_path) {
  const MapFile file = read_map_file(yaml_path);
  const std::string image_path =
      (std::filesystem::path(yaml_path).parent_path() / file.image).string();
  return map_from_image(parse_pgm(read_file(image_path, longest_image), image_path),
                        {file.resolution,
                         {file.origin[0], file.origin[1]},
                         file.negate == 1,
                         file.occupied_thresh,
                         file.free_thresh});
}

}  // namespace

OccupancyMap load_map(const std::string& yaml_path) {
  static FileCache<OccupancyMap> known;
  return known.get(yaml_path, [&] { return read_map(yaml_path); });
}

std::shared_ptr<const CostMap> load_costs(const std::string& yaml_path,
                                          const InflationParams& params) {
  struct Known {
    InflationParams params;
    std::shared_ptr<const CostMap> costs;
  };
  static FileCache<Known> known;
  const auto compute = [&] {
    return Known{params, std::make_shared<const CostMap>(load_map(yaml_path), params)};
  };
  const Known found = known.get(yaml_path, compute);
  return found.params == params ? found.costs : compute().costs;
}

}  // namespace tocsin::navigation
