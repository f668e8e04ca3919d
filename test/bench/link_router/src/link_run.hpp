// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/link_path.hpp"
#include "foundation/traffic_class.hpp"
#include "link_router/link_router_params.hpp"
#include "mission_traffic.hpp"

namespace tocsin::bench {

constexpr Duration warm_up = std::chrono::seconds(12);  ///< of a run, not counted
constexpr Duration late_after = std::chrono::milliseconds(250);

/// Which of the router's steps are on.
struct Steps {
  bool adaptation = true;  ///< the camera follows its budget
  bool repair = true;
  bool categories = false;  ///< the radio has the queues of 802.11e
  DscpOfClass dscp;
  bool pause = false;  ///< the gates of the recorded policy
  router::LinkRouterParams params;
  std::optional<radio::ChannelParams> first;   ///< in place of the mission's channel
  std::optional<radio::ChannelParams> second;  ///< of a second path; none: there is one
  PathUse urgent = PathUse::repair;            ///< of classes critical and high
  std::optional<Time> unplugged;               ///< when `first` dies
};

/// What users feel of one run; of the vehicle's samples, after the first 12 s.
struct Figures {
  double critical_p50_ms = 0;
  double critical_p99_ms = 0;
  double high_p50_ms = 0;
  double high_p99_ms = 0;
  double critical_late = 0;  ///< [%] lost, or later than 250 ms
  double high_late = 0;
  double critical_lost = 0;  ///< [%] never delivered
  double high_lost = 0;
  double low_delivered = 0;       ///< [%]
  double location_age_p99_s = 0;  ///< at the station, each 0.1 s
  double picture_p99_ms = 0;
  double pictures_per_s = 0;
  double picture_kb = 0;                   ///< mean size of those delivered
  double airtime = 0;                      ///< [%]
  double acknowledgements_per_s = 0;       ///< of both sides
  double acknowledgement_bytes_per_s = 0;  ///< with all headers
  double repairs_per_s = 0;
  double critical_kb_per_s = 0;  ///< with all headers, of the vehicle's
  double unplugged_late = 0;     ///< [%] critical_late, of the 2 s after Steps::unplugged
  double unreachable = 0;        ///< [%] of the time: nothing written then can be there in 250 ms
  double least_p99_ms = 0;       ///< what is written then can be there after so long in 99 %
};

/// Sends the traffic of the mission over the radio with a router on each side.
[[nodiscard]] Figures run_link(const MissionTraffic& traffic, const Steps& steps,
                               std::uint64_t seed);

/// Of each critical sample of the vehicle that counts, in their order, whether it is late or lost.
[[nodiscard]] std::vector<bool> critical_misses(const MissionTraffic& traffic, const Steps& steps,
                                                std::uint64_t seed);

/// Figures::unreachable and ::least_p99_ms, which nobody could better: something arrives at the
/// first arrival of a packet of 100 bytes that is sent then or later, one each 5 ms, alone on the
/// radio. What a class has late or lost beyond this is the router's doing.
void add_bounds(const MissionTraffic& traffic, const Steps& steps, std::uint64_t seed,
                Figures& figures);

}  // namespace tocsin::bench
