// SPDX-License-Identifier: Apache-2.0
#include "navigation/map_loader.hpp"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::navigation {
namespace {

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

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || !(bytes << file.rdbuf()).good()) {
    throw ConfigError(path + ": cannot be read, or is empty");
  }
  return bytes.str();
}

void require(const YAML::Node& node, const char* key, const std::string& path) {
  if (!node[key]) throw ConfigError("map." + std::string(key) + ": missing (" + path + ")");
}

MapFile read_map_file(const std::string& path) {
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

}  // namespace

OccupancyMap map_from_image(const GrayImage& image, const MapScale& scale) {
  const Grid grid{image.width, image.height, scale.resolution_m, scale.origin};
  std::vector<Cell> cells(grid.size(), Cell::unknown);
  for (int row = 0; row < grid.height; ++row) {
    const std::size_t from_top = grid.offset({0, grid.height - 1 - row});
    for (int column = 0; column < grid.width; ++column) {
      const double white =
          image.pixels[from_top + static_cast<std::size_t>(column)] / double(image.max);
      const double black = scale.negate ? white : 1 - white;
      Cell& cell = cells[grid.offset({column, row})];
      if (black > scale.occupied_thresh) cell = Cell::occupied;
      if (black < scale.free_thresh) cell = Cell::free;
    }
  }
  return {grid, std::move(cells)};
}

OccupancyMap load_map(const std::string& yaml_path) {
  const MapFile file = read_map_file(yaml_path);
  const std::string image_path =
      (std::filesystem::path(yaml_path).parent_path() / file.image).string();
  return map_from_image(parse_pgm(read_bytes(image_path), image_path),
                        {file.resolution,
                         {file.origin[0], file.origin[1]},
                         file.negate == 1,
                         file.occupied_thresh,
                         file.free_thresh});
}

}  // namespace tocsin::navigation
