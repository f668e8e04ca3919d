// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "navigation/occupancy_map.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Publishes the map of the floor once, for whoever comes whenever, and the vehicle's frame in it
/// with each position: for the operator's page, Foxglove, ROS 2's tools, and for bags that they
/// open.
class MapServerComponent final : public Component {
 public:
  struct Params {
    std::string map_file;
    std::string vehicle_frame = "base_footprint";
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_file", map_file, "map in the format of ROS's map_server (YAML); required");
      v("vehicle_frame", vehicle_frame, "tf frame that location is told as; empty: no tf");
    }
  };

  /// Throws ConfigError when the map cannot be read.
  MapServerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void publish_map(Time now);

  Input<topic::Location> location_{*this};
  Output<topic::Map> map_{*this};
  Output<topic::Tf> tf_{*this};
  const Params params_;
  const navigation::OccupancyMap content_;
  bool sent_ = false;
};

}  // namespace tocsin
