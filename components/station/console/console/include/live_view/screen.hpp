// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/free_space.hpp"
#include "foundation/freshness.hpp"
#include "live_view/traffic_table.hpp"
#include "terminal/screen.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// The last of something, and when it was last known to be the case.
template <class Value>
struct Heard {
  Value value;
  Time at{};
};

/// A place in the map.
struct Place {
  double x_m = 0;
  double y_m = 0;
};

/// Room on the disk of the run folder of this host.
struct Disk {
  double free_mib = 0;
  [[nodiscard]] bool is_full() const { return free_mib * 1024 * 1024 < full_below_bytes; }
};

/// The site that the vehicle speaks with in place of this one, told as long as it does.
struct OtherSite {
  std::string name;
};

/// All that the view shows, as it was last heard.
struct ViewState {
  std::optional<Heard<Disk>> disk;
  std::optional<Heard<OtherSite>> other_site;
  std::optional<Heard<tocsin_msgs::msg::SafetyStatus>> safety;
  std::optional<Heard<tocsin_msgs::msg::MissionStatus>> mission;
  std::optional<Heard<Place>> location;
  std::optional<Heard<tocsin_msgs::msg::NavigationStatus>> navigation;
  std::optional<Heard<tocsin_msgs::msg::NetworkQuality>> quality;
  std::optional<Heard<tocsin_msgs::msg::TransmissionState>> uxv;
  std::optional<Heard<tocsin_msgs::msg::TransmissionState>> gcs;
  std::optional<Heard<tocsin_msgs::msg::LinkState>> uplink;    ///< none without a router
  std::optional<Heard<tocsin_msgs::msg::LinkState>> downlink;  ///< none without a router
  std::vector<TrafficRow> traffic;
};

/// What is shown at `now` on a terminal of that size: at most so many lines, in the order of their
/// weight. What finds no room is left out from the end, and of a line the less important words. A
/// stale value is grey and says its age, an unknown one is not shown. Pure.
[[nodiscard]] std::vector<terminal::Line> page(const ViewState& state, Time now,
                                               terminal::Size size, const FreshnessLimits& limits);

/// The same in one line, for a log.
[[nodiscard]] std::string summary_line(const ViewState& state, Time now,
                                       const FreshnessLimits& limits);

}  // namespace tocsin
