// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "live_view/screen.hpp"

namespace tocsin {

inline const Time t0{std::chrono::hours(1)};
inline constexpr FreshnessLimits limits{3, 30};

inline TrafficRow camera_row() {
  return {"camera/image_raw/compressed",
          "low",
          Counting::counted,
          7.8,
          seconds(0.12),
          95,
          100,
          11,
          true,
          seconds(0.5),
          0.25};
}

/// What the router of a role tells of its way.
inline tocsin_msgs::msg::LinkState link_of(const std::string& role) {
  tocsin_msgs::msg::LinkState link;
  link.role(role);
  link.live_peers(1);
  link.capacity_bytes_per_s(180000);
  link.capacity_measured(true);
  link.backlog_s(0.012F);
  link.loss(0.03F);
  link.scale(0.75F);
  link.bytes(1000);
  link.discovery_bytes(20);
  link.classes().resize(1);
  link.classes()[0].traffic_class("critical");
  link.classes()[0].late(3);
  link.classes()[0].repaired(12);
  return link;
}

/// `state` with a router on both sides, heard at `t0`.
inline ViewState routed(ViewState state) {
  state.uplink = {link_of("uxv"), t0};
  state.downlink = {link_of("gcs"), t0};
  return state;
}

/// A vehicle under way, all of it heard at `t0`.
inline ViewState full_state() {
  ViewState state;
  tocsin_msgs::msg::MissionStatus mission;
  mission.mission("mission_a");
  mission.state("running");
  mission.waypoint(3);
  mission.waypoints(9);
  mission.elapsed_s(125);
  mission.goals_sent(4);
  state.mission = {mission, t0};
  tocsin_msgs::msg::NavigationStatus navigation;
  navigation.state("driving");
  navigation.distance_m(4.25);
  state.navigation = {navigation, t0};
  tocsin_msgs::msg::NetworkQuality quality;
  quality.per_percent(12.5F);
  quality.probe_bytes(84'000);
  quality.signal_dbm(std::numeric_limits<float>::quiet_NaN());
  state.quality = {quality, t0};
  tocsin_msgs::msg::TransmissionState decision;
  decision.policy("tocp_dsp");
  decision.reason("cusum_alarm");
  decision.qni(50);
  decision.deadline_s(26);
  state.uxv = {decision, t0};
  decision.active(true);
  state.gcs = {decision, t0};
  state.safety = {{}, t0};
  state.safety->value.enabled(true);
  state.location = {{1.234, 0}, t0};
  state.traffic.push_back(camera_row());
  return state;
}

}  // namespace tocsin
