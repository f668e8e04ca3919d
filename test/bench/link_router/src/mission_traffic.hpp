// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/wall.hpp"
#include "link_router/transmission.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::bench {

/// One topic that one process writes.
struct TrafficSource {
  std::string topic;
  radio::Direction direction = radio::Direction::uplink;
  router::StreamRule rule;
};

/// What the components of a mission wanted to send, and where the vehicle was.
struct MissionTraffic {
  struct Write {
    Time time;
    std::size_t source;  ///< in `sources`
    std::size_t bytes;
  };
  struct Place {
    Time time;
    double x_m;
    double y_m;
  };
  struct Gate {
    Time time;
    bool open;
  };
  std::vector<TrafficSource> sources;
  std::vector<Write> writes;  ///< by time
  std::vector<Place> places;  ///< by time
  std::vector<Time> echoes;   ///< network_monitor's requests
  std::vector<Gate> gates;    ///< of the vehicle
  radio::ChannelParams channel;
  std::vector<geometry::Wall> walls;
  Time begin{};
  Time end{};
};

/// Which mission is played.
struct Mission {
  bool b = false;     ///< exhaustive scanning; else A, path following
  bool demo = false;  ///< as bringup/demo plays it; else as config/experiments/thesis.yaml says
  std::string policy;
  int seed = 1;
  double duration_s = 600;  ///< it ends sooner when its last goal is reached
};

/// The installed folder share/tocsin, absolute.
[[nodiscard]] std::string share();

/// Plays it in simulated time, with the policy's parameters as fitted. Throws ConfigError.
[[nodiscard]] MissionTraffic record_mission(const Mission& mission);

}  // namespace tocsin::bench
