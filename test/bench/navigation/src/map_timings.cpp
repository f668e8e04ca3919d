// SPDX-License-Identifier: Apache-2.0
#include "map_timings.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "mapping/local_mapper.hpp"
#include "mapping/loop_finder.hpp"
#include "mapping/mapper.hpp"
#include "planted_loops.hpp"

namespace tocsin::bench {
namespace {

using geometry::Pose;
using mapping::Points;
using navigation::Cell;
using navigation::Grid;
using navigation::OccupancyMap;

constexpr double cell_m = 0.02;
constexpr double side_m = 40;

double time_ms(const std::function<void()>& work) {
  double least = infinity;
  for (int i = 0; i < 5; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count());
  }
  return least;
}

Timing timing_of(std::vector<double> times_ms) {
  std::sort(times_ms.begin(), times_ms.end());
  const auto n = static_cast<double>(times_ms.size());
  return {std::accumulate(times_ms.begin(), times_ms.end(), 0.0) / n,
          times_ms[static_cast<std::size_t>(0.99 * (n - 1))]};
}

/// A building of rooms of 5 x 5 m with doors of 1 m, and furniture in them.
OccupancyMap building() {
  const int side = static_cast<int>(side_m / cell_m);
  const Grid grid{side, side, cell_m, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  const auto fill = [&](double x_m, double y_m, double width_m, double height_m, Cell cell) {
    for (double y = y_m; y < y_m + height_m; y += cell_m) {
      for (double x = x_m; x < x_m + width_m; x += cell_m) {
        if (const auto c = grid.cell_of({x, y})) cells[grid.offset(*c)] = cell;
      }
    }
  };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0.5, 4);
  for (double at_m = 0; at_m < side_m; at_m += 5) {
    fill(at_m, 0, 0.1, side_m, Cell::occupied);
    fill(0, at_m, side_m, 0.1, Cell::occupied);
  }
  for (double y_m = 0; y_m < side_m; y_m += 5) {
    for (double x_m = 0; x_m < side_m; x_m += 5) {
      fill(x_m, y_m + place(random), 0.1, 1, Cell::free);
      fill(x_m + place(random), y_m, 1, 0.1, Cell::free);
      fill(x_m + place(random), y_m + place(random), 0.6, 0.4, Cell::occupied);
    }
  }
  return {grid, std::move(cells)};
}

mapping::Scan scan_at(const OccupancyMap& map, const Pose& pose, std::mt19937& random) {
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<double> ranges_m;
  for (int i = 0; i < 360; ++i) {
    const auto range_m = map.raycast(position(pose), pose.heading_rad + i * degree, 12);
    ranges_m.push_back(range_m ? *range_m + noise(random) : infinity);
  }
  return laser::make_scan(ranges_m, {{}, 0, degree});
}

/// Places 0.25 m apart on a way through the building's middle.
std::vector<Pose> way() {
  std::vector<Pose> poses;
  for (int i = 0; i < 80; ++i)
    poses.push_back({11.3 + 0.2 * i, 12.5 + 0.4 * std::sin(i * 0.2), 0.3});
  return poses;
}

mapping::Submap submap_of(const OccupancyMap& map, std::size_t from, std::size_t until,
                          std::mt19937& random) {
  const mapping::LocalParams params;
  mapping::Submap submap(0, params.resolution_m, params.sigma_m);
  const auto poses = way();
  for (std::size_t i = from; i < until; ++i) {
    submap.insert(i, scan_at(map, poses[i], random), poses[i]);
  }
  submap.finish();
  (void)submap.bounds();
  return submap;
}

}  // namespace

Timing time_matches() {
  std::mt19937 random(1);
  const OccupancyMap map = building();
  const mapping::Submap submap = submap_of(map, 0, 20, random);
  const mapping::LocalParams params;
  mapping::SearchParams search_params;
  search_params.guess_weight = params.guess_weight;
  std::uniform_real_distribution<double> off(-1, 1);
  std::vector<double> times_ms;
  for (int i = 0; i < 300; ++i) {
    const Pose pose = way()[static_cast<std::size_t>(i % 24)];
    const Points hits = scan_at(map, pose, random).hits;
    const Pose guess{pose.x_m + 0.3 * off(random), pose.y_m + 0.3 * off(random),
                     pose.heading_rad + 0.26 * off(random)};
    times_ms.push_back(time_ms([&] {
      const Points points = laser::thinned(hits, params.thin_m);
      const auto found = search(submap.bounds(), points, guess, {0.3, 0.26}, search_params);
      if (found) (void)refine(submap.field(), points, found->pose, guess);
    }));
  }
  return timing_of(times_ms);
}

Timing time_loop_searches() {
  std::mt19937 random(1);
  const OccupancyMap map = building();
  const mapping::Submap submap = submap_of(map, 0, 20, random);
  std::uniform_real_distribution<double> off(-1, 1);
  std::vector<double> times_ms;
  for (std::size_t i = 0; i < 40; ++i) {
    const std::size_t last = 8 + i;
    const Pose pose = way()[last];
    Points points;
    for (std::size_t k = last - 8; k < last; ++k) {
      const Points part =
          laser::transformed(scan_at(map, way()[k], random).hits, relative(pose, way()[k]));
      points.insert(points.end(), part.begin(), part.end());
    }
    points = laser::thinned(points, mapping::MapperParams{}.loop_thin_m);
    const Pose guess{pose.x_m + 4 * off(random), pose.y_m + 4 * off(random),
                     pose.heading_rad + 0.78 * off(random)};
    times_ms.push_back(time_ms([&] { (void)find_loop(submap, points, guess, {4, 0.785}); }));
  }
  return timing_of(times_ms);
}

Timing time_solve(std::size_t nodes) {
  TownGraph town = town_graph(nodes, 0);
  town.graph.solve();
  std::vector<double> times_ms;
  for (int i = 0; i < 5; ++i) {
    times_ms.push_back(time_ms([&] {
      mapping::PoseGraph graph = town.graph;
      graph.add({10, nodes - 10, relative(town.truth[10], town.truth[nodes - 10]),
                 Eigen::Matrix3d::Identity() * 1e4, true});
      mapping::SolveParams params;
      params.graduated = false;
      graph.solve(params);
    }));
  }
  return timing_of(times_ms);
}

}  // namespace tocsin::bench
