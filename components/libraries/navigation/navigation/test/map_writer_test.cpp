// SPDX-License-Identifier: Apache-2.0
#include "navigation/map_writer.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "navigation/map_loader.hpp"

namespace tocsin::navigation {
namespace {

/// Two rows of three cells: the lower one free, occupied, unknown; the upper one all free.
OccupancyMap small_map() {
  return {Grid{3, 2, 0.05, {-1.25, 0.1}},
          {Cell::free, Cell::occupied, Cell::unknown, Cell::free, Cell::free, Cell::free}};
}

TEST(PgmOf, HasTheGreysOfMapSaverFromTheTop) {
  EXPECT_EQ(pgm_of(small_map()), "P5\n3 2\n255\n\xFE\xFE\xFE\xFE" + std::string(1, '\0') + "\xCD");
}

TEST(WriteMap, WritesWhatLoadMapReads) {
  const TemporaryFolder folder;
  const OccupancyMap map = small_map();
  write_map(map, folder.path("hall: 1"));
  const OccupancyMap read = load_map(folder.path("hall: 1.yaml"));
  EXPECT_EQ(read.cells(), map.cells());
  EXPECT_EQ(read.grid().width, 3);
  EXPECT_DOUBLE_EQ(read.grid().resolution_m, 0.05);
  EXPECT_DOUBLE_EQ(read.grid().origin.x_m, -1.25);
  EXPECT_DOUBLE_EQ(read.grid().origin.y_m, 0.1);
}

TEST(WriteMap, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string name = folder.path("no/such/map");
  try {
    write_map(small_map(), name);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()).find(name + ".pgm: cannot be written: "), 0U);
  }
}

TEST(WriteMap, RefusesAMapThatNobodyCouldRead) {
  const Grid grid{5001, 5000, 0.05, {}};
  const OccupancyMap map(grid, std::vector<Cell>(grid.size(), Cell::unknown));
  EXPECT_THROW(write_map(map, "/nowhere"), ConfigError);
}

}  // namespace
}  // namespace tocsin::navigation
