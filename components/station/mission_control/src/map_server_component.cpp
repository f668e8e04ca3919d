// SPDX-License-Identifier: Apache-2.0
#include "map_server/map_server_component.hpp"

#include <utility>

#include "foundation/error.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration try_again = std::chrono::seconds(1);

navigation::OccupancyMap load(const std::string& name, const std::string& map_file) {
  if (map_file.empty()) throw ConfigError(name + ".map_file: is required");
  return navigation::load_map(map_file);
}

/// Occupancy of a cell [%] as map_server tells it in mode trinary; -1 is unknown.
std::int8_t occupancy(navigation::Cell cell) {
  switch (cell) {
    case navigation::Cell::free:
      return 0;
    case navigation::Cell::occupied:
      return 100;
    case navigation::Cell::unknown:
      return -1;
  }
  return -1;
}

topic::Map::Message message_of(const navigation::OccupancyMap& map) {
  topic::Map::Message message;
  message.header().frame_id("map");
  const navigation::Grid& grid = map.grid();
  message.info().resolution(static_cast<float>(grid.resolution_m));
  message.info().width(static_cast<std::uint32_t>(grid.width));
  message.info().height(static_cast<std::uint32_t>(grid.height));
  message.info().origin().position().x(grid.origin.x_m);
  message.info().origin().position().y(grid.origin.y_m);
  message.info().origin().orientation().w(1);
  message.data().reserve(grid.size());
  for (const navigation::Cell cell : map.cells()) message.data().push_back(occupancy(cell));
  return message;
}

topic::Tf::Message transform_of(const topic::Location::Message& location,
                                const std::string& vehicle_frame) {
  const auto& pose = location.pose().pose();
  geometry_msgs::msg::TransformStamped transform;
  transform.header(location.header());
  transform.child_frame_id(vehicle_frame);
  transform.transform().translation().x(pose.position().x());
  transform.transform().translation().y(pose.position().y());
  transform.transform().translation().z(pose.position().z());
  transform.transform().rotation(pose.orientation());
  topic::Tf::Message message;
  message.transforms().push_back(transform);
  return message;
}

}  // namespace

MapServerComponent::MapServerComponent(Context& context, const Params& params)
    : Component(context), params_(params), content_(load(context.name, params.map_file)) {}

void MapServerComponent::tick(Time now) {
  publish_map(now);
  while (const auto location = location_.take()) {
    if (params_.vehicle_frame.empty()) continue;
    // A lost one is replaced by the next.
    (void)tf_.write(transform_of(*location, params_.vehicle_frame));
  }
}

void MapServerComponent::publish_map(Time now) {
  if (sent_) return;
  topic::Map::Message message = message_of(content_);
  message.header().stamp(wall(now));
  message.info().map_load_time(wall(now));
  sent_ = map_.write(std::move(message)) != Status::failed;
  if (!sent_) wake_at(now + try_again);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::MapServerComponent)
