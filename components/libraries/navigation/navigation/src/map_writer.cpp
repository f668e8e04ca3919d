// SPDX-License-Identifier: Apache-2.0
#include "navigation/map_writer.hpp"

#include <array>
#include <cstdio>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::navigation {
namespace {

constexpr std::size_t most_cells = 25'000'000;  // of parse_pgm

char grey_of(Cell cell) {
  switch (cell) {
    case Cell::free:
      return static_cast<char>(254);
    case Cell::occupied:
      return 0;
    default:
      return static_cast<char>(205);
  }
}

std::string yaml_of(const Grid& grid, const std::string& image) {
  std::array<char, 512> text{};
  const int length =
      std::snprintf(text.data(), text.size(),
                    "mode: trinary\nresolution: %.9g\norigin: [%.9g, %.9g, 0]\nnegate: 0\n"
                    "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                    grid.resolution_m, grid.origin.x_m, grid.origin.y_m);
  return "image: \"" + image + "\"\n" + std::string(text.data(), static_cast<std::size_t>(length));
}

void write(const std::string& path, const std::string& text) {
  const auto error = replace_file(path, text);
  if (error) throw ConfigError(path + ": cannot be written: " + error.message());
}

}  // namespace

std::string pgm_of(const OccupancyMap& map) {
  const Grid& grid = map.grid();
  std::string image =
      "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  image.reserve(image.size() + grid.size());
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width; ++column) {
      image.push_back(grey_of(map.at(CellIndex{column, row})));
    }
  }
  return image;
}

void write_map(const OccupancyMap& map, const std::string& name) {
  if (map.grid().size() > most_cells) {
    throw ConfigError(name + ": the map has " + std::to_string(map.grid().size()) +
                      " cells, more than 25 million; a coarser resolution has fewer");
  }
  write(name + ".pgm", pgm_of(map));
  write(name + ".yaml",
        yaml_of(map.grid(), std::filesystem::path(name + ".pgm").filename().string()));
}

}  // namespace tocsin::navigation
