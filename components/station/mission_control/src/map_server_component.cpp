// SPDX-License-Identifier: Apache-2.0
#include "map_server/map_server_component.hpp"

#include <utility>

#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration try_again = std::chrono::seconds(1);
constexpr double default_resolution_m = 0.05;
constexpr double least_resolution_m = 0.01;
constexpr double most_resolution_m = 1;

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
    : Component(context), params_(params), map_(*this, default_resolution_m) {
  if (params.map_file.empty()) {
    tiles_.emplace(*this);
  } else {
    file_ = navigation::load_map(params.map_file);
  }
}

void MapServerComponent::tick(Time now) {
  publish_file(now);
  while (const auto tile = tiles_ ? tiles_->take() : nullptr) take_tile(*tile);
  map_.publish(wall(now), now);
  wake_at(map_.deadline());
  while (const auto location = location_.take()) {
    if (params_.vehicle_frame.empty()) continue;
    // A lost one is replaced by the next.
    (void)tf_.write(transform_of(*location, params_.vehicle_frame));
  }
}

void MapServerComponent::publish_file(Time now) {
  if (!file_) return;
  if (map_.publish_whole(*file_, wall(now))) {
    file_.reset();
  } else {
    wake_at(now + try_again);
  }
}

void MapServerComponent::take_tile(const topic::MapTiles::Message& message) {
  const double resolution_m = message.resolution();
  if (!(resolution_m >= least_resolution_m && resolution_m <= most_resolution_m)) {
    return refuse(message, "its resolution is outside [0.01, 1] m");
  }
  auto tile = navigation::unpacked_tile(message.cells());
  if (message.side() != navigation::TileMap::side || !tile) {
    return refuse(message, "it has not 64 x 64 cells of the codes 0 to 2");
  }
  if (!belongs(message)) return;
  const auto put = map_.put({message.column(), message.row()}, std::move(*tile));
  if (put == navigation::TileMap::Put::too_large) {
    refuse(message, "the map would have more than 25 million cells");
  }
}

/// A tile of another session may be late. When no other ones come, the vehicle has begun anew.
bool MapServerComponent::belongs(const topic::MapTiles::Message& message) {
  constexpr int certain = 3;
  if (session_ && session_->id == message.session()) {
    session_->others = 0;
    return true;
  }
  if (session_ && ++session_->others < certain) return false;
  session_ = Session{message.session(), 0};
  map_.begin(message.resolution());
  log().info("map {} of the vehicle begins", message.session());
  return true;
}

void MapServerComponent::refuse(const topic::MapTiles::Message& message, const char* reason) {
  log().warn("tile ({}, {}) of the vehicle's map is refused: {}", message.column(), message.row(),
             reason);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::MapServerComponent)
