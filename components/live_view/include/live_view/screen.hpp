// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "live_view/traffic_table.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// All that the view shows, as it was last heard.
struct ViewState {
  std::optional<tocsin_msgs::msg::MissionStatus> mission;
  std::optional<tocsin_msgs::msg::NavigationStatus> navigation;
  std::optional<tocsin_msgs::msg::NetworkQuality> quality;
  std::optional<tocsin_msgs::msg::TransmissionState> uxv;
  std::optional<tocsin_msgs::msg::TransmissionState> gcs;
  bool located = false;
  double x_m = 0;
  double y_m = 0;
  double location_age_s = 0;
  std::vector<TrafficRow> traffic;
};

/// A page of at most 100 columns. `colour`: with ANSI colours.
[[nodiscard]] std::string page(const ViewState& state, bool colour);

/// The same in one line, for a log.
[[nodiscard]] std::string summary_line(const ViewState& state);

}  // namespace tocsin
