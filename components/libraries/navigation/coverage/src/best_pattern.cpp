// SPDX-License-Identifier: Apache-2.0
#include "best_pattern.hpp"

#include <algorithm>
#include <utility>

#include "coverage/covered_floor.hpp"
#include "foundation/numbers.hpp"
#include "wall_directions.hpp"

namespace tocsin::coverage {
namespace {

constexpr double turn_m = 0.5;    // a swath more costs as much as this way
constexpr double cell_m = 1.0;    // a cell more, with the drive to it
constexpr double detour = 2.5;    // what is left out is covered on ways so much longer
constexpr double clearly = 0.85;  // of the cost: another direction is worth a cell of its own
constexpr int phases = 4;         // first lines that are tried
constexpr std::size_t least_swaths = 4;  // of a cell that may get a direction of its own

struct Choice {
  std::vector<SwathCell> cells;
  double cost_m = infinity;
};

double cost_of(const std::vector<SwathCell>& cells, const Mask& floor, const Tool& tool) {
  CoveredFloor covered(floor, tool.width_m);
  double sum = 0;
  for (const SwathCell& cell : cells) {
    covered.drive(cell);
    for (const Swath& swath : cell) sum += length_m(swath) + tool.spacing_m + turn_m;
    sum += cell_m;
  }
  return sum + detour * covered.uncovered_m2() / tool.width_m;
}

/// Tries these directions, for each some first lines and lines fitted to the mask.
Choice best_of(const Floor& floor, const Tool& tool, const std::vector<double>& directions) {
  Choice best;
  const auto consider = [&](const Pattern& pattern) {
    auto cells = swath_cells(floor.centres, pattern);
    const double cost_m = cost_of(cells, floor.floor, tool);
    if (cost_m < best.cost_m) best = {std::move(cells), cost_m};
  };
  for (const double direction : directions) {
    for (int k = 0; k < phases; ++k) {
      consider({direction, tool.spacing_m, tool.spacing_m * k / phases});
    }
    for (const double inset : {0.5, 1.0, 1.5}) {
      consider(fitted(floor.centres, {direction, tool.spacing_m, 0},
                      inset * floor.centres.grid.resolution_m));
    }
  }
  return best;
}

/// Along walls and across, and some others.
std::vector<double> directions_for(const Mask& mask, int others) {
  std::vector<double> directions;
  for (const double wall : wall_directions(mask, 4)) {
    directions.push_back(wall);
    directions.push_back(wall + pi / 2);
  }
  for (int i = 0; i < others; ++i) directions.push_back(pi * i / others);
  return directions;
}

/// The part of the floor that a cell's swaths stand for.
Floor floor_of(const SwathCell& cell, const Floor& all, const Tool& tool) {
  Mask within(all.centres.grid);
  const Stamp around(within.grid, tool.spacing_m / 2 + within.grid.resolution_m);
  for (const Swath& swath : cell) {
    const int steps = 1 + static_cast<int>(length_m(swath) / within.grid.resolution_m);
    for (int i = 0; i <= steps; ++i) {
      const auto at = within.grid.cell_of(between(swath.from, swath.to, double(i) / steps));
      if (!at) continue;
      around.at(*at, [&](std::size_t offset) { within.cells[offset] = all.centres.cells[offset]; });
    }
  }
  Mask floor = reached_from(within, all.floor, tool.width_m);
  for (std::size_t i = 0; i < floor.cells.size(); ++i) {  // what others stand for is theirs
    if (all.centres.cells[i] != 0) floor.cells[i] = within.cells[i];
  }
  return {std::move(within), std::move(floor)};
}

}  // namespace

std::vector<SwathCell> decompose(const Floor& floor, const Tool& tool) {
  const auto directions = directions_for(floor.centres, 12);
  std::vector<SwathCell> result;
  for (SwathCell& cell : best_of(floor, tool, directions).cells) {
    if (cell.size() < least_swaths) {
      result.push_back(std::move(cell));
      continue;
    }
    const Floor part = floor_of(cell, floor, tool);
    const double cost_m = cost_of({cell}, part.floor, tool);
    Choice other = best_of(part, tool, directions);
    if (other.cost_m >= clearly * cost_m) {
      result.push_back(std::move(cell));
    } else {
      std::move(other.cells.begin(), other.cells.end(), std::back_inserter(result));
    }
  }
  return result;
}

}  // namespace tocsin::coverage
