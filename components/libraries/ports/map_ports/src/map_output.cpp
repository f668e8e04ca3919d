// SPDX-License-Identifier: Apache-2.0
#include "map_ports/map_output.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace tocsin {
namespace {

using navigation::Cell;
using navigation::TileMap;

constexpr Duration update_period = std::chrono::milliseconds(500);
constexpr Duration whole_period = std::chrono::seconds(2);
constexpr Duration late_period = std::chrono::seconds(3);  // after that

std::int8_t occupancy(Cell cell) {
  switch (cell) {
    case Cell::free:
      return 0;
    case Cell::occupied:
      return 100;
    case Cell::unknown:
      return -1;
  }
  return -1;
}

bool is_same_place(const navigation::Grid& a, const navigation::Grid& b) {
  return a.width == b.width && a.height == b.height && a.resolution_m == b.resolution_m &&
         a.origin.x_m == b.origin.x_m && a.origin.y_m == b.origin.y_m;
}

}  // namespace

topic::Map::Message grid_message(const navigation::Grid& grid, std::vector<std::int8_t> percents) {
  assert(percents.size() == grid.size());
  topic::Map::Message message;
  message.header().frame_id("map");
  message.info().resolution(static_cast<float>(grid.resolution_m));
  message.info().width(static_cast<std::uint32_t>(grid.width));
  message.info().height(static_cast<std::uint32_t>(grid.height));
  message.info().origin().position().x(grid.origin.x_m);
  message.info().origin().position().y(grid.origin.y_m);
  message.info().origin().orientation().w(1);
  message.data(std::move(percents));
  return message;
}

topic::Map::Message map_message(const navigation::OccupancyMap& map) {
  std::vector<std::int8_t> percents;
  percents.reserve(map.grid().size());
  for (const Cell cell : map.cells()) percents.push_back(occupancy(cell));
  return grid_message(map.grid(), std::move(percents));
}

MapOutput::MapOutput(Component& owner, double resolution_m)
    : map_(owner), updates_(owner), tiles_(resolution_m) {}

TileMap::Put MapOutput::put(TileMap::Index index, TileMap::Tile tile) {
  const TileMap::Put put = tiles_.put(index, std::move(tile));
  if (put == TileMap::Put::changed) changed_.insert(index);
  return put;
}

void MapOutput::begin(double resolution_m) {
  tiles_ = TileMap(resolution_m);
  changed_.clear();
  published_ = {};
}

void MapOutput::publish(const builtin_interfaces::msg::Time& stamp, Time now) {
  if (now < deadline()) return;
  next_ = now + update_period;
  const bool is_due = is_stale_ && now >= next_whole_ + late_period;
  if (is_due || !is_same_place(published_, tiles_.grid())) return publish_grown(stamp, now);
  for (const TileMap::Index index : std::exchange(changed_, {})) publish_tile(index, stamp);
  is_stale_ = true;
}

Time MapOutput::deadline() const {
  const Time for_late = is_stale_ ? next_whole_ + late_period : Time::max();
  return changed_.empty() ? for_late : std::min(next_, for_late);
}

bool MapOutput::publish_whole(const navigation::OccupancyMap& map,
                              const builtin_interfaces::msg::Time& stamp) {
  topic::Map::Message message = map_message(map);
  message.header().stamp(stamp);
  message.info().map_load_time(stamp);
  return map_.write(std::move(message)) != Status::failed;
}

void MapOutput::publish_grown(const builtin_interfaces::msg::Time& stamp, Time now) {
  if (now < next_whole_) {
    next_ = next_whole_;
    return;
  }
  next_whole_ = now + whole_period;
  if (!publish_whole(tiles_.map(), stamp)) return;
  published_ = tiles_.grid();
  is_stale_ = false;
  changed_.clear();
}

void MapOutput::publish_tile(TileMap::Index index, const builtin_interfaces::msg::Time& stamp) {
  const navigation::CellIndex corner = tiles_.corner_of(index);
  topic::MapUpdates::Message message;
  message.header().stamp(stamp);
  message.header().frame_id("map");
  message.x(corner.column);
  message.y(corner.row);
  message.width(TileMap::side);
  message.height(TileMap::side);
  for (const Cell cell : tiles_.tiles().at(index)) message.data().push_back(occupancy(cell));
  if (updates_.write(std::move(message)) == Status::failed) changed_.insert(index);
}

}  // namespace tocsin
