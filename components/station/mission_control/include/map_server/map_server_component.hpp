// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "map_ports/map_output.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Publishes a map of the floor, from a file or as the vehicle makes it, for whoever comes
/// whenever, and the vehicle's frame in it with each position: for the operator's page, Foxglove,
/// ROS 2's tools, and for bags that they open.
class MapServerComponent final : public Component {
 public:
  struct Params {
    std::string map_file;
    std::string vehicle_frame = "base_footprint";
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_file", map_file,
        "map in the format of ROS's map_server (YAML); empty: what comes on `map_tiles`");
      v("vehicle_frame", vehicle_frame, "tf frame that location is told as; empty: no tf");
    }
  };

  /// Throws ConfigError when the map cannot be read.
  MapServerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  /// Of a vehicle.
  struct Session {
    std::uint32_t id = 0;
    int others = 0;  ///< tiles in a row of another one
  };
  void publish_file(Time now);
  void take_tile(const topic::MapTiles::Message& message);
  [[nodiscard]] bool belongs(const topic::MapTiles::Message& message);
  void refuse(const topic::MapTiles::Message& message, const char* reason);

  Input<topic::Location> location_{*this};
  Output<topic::Tf> tf_{*this};
  const Params params_;
  std::optional<OptionalInput<topic::MapTiles>> tiles_;  ///< without a file
  MapOutput map_;
  std::optional<navigation::OccupancyMap> file_;  ///< until it is sent
  std::optional<Session> session_;
};

}  // namespace tocsin
