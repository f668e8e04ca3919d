// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "navigation/occupancy_map.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Publishes the map of the floor once, for whoever comes whenever: the operator's page, Foxglove,
/// ROS 2's tools.
class MapServerComponent final : public Component {
 public:
  struct Params {
    std::string map_file;
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_file", map_file, "map in the format of ROS's map_server (YAML); required");
    }
  };

  /// Throws ConfigError when the map cannot be read.
  MapServerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  Output<topic::Map> map_{*this};
  const navigation::OccupancyMap content_;
  bool sent_ = false;
};

}  // namespace tocsin
