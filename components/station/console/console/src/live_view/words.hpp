// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "live_view/screen.hpp"

/// What the view says of each value, in the words of one line.
namespace tocsin::view {

/// `value` with its unit; `-` for NaN, which stands for what was not measured.
[[nodiscard]] std::string number(double value, int digits, const char* unit);
/// The waypoint that is being driven to, of all of them.
[[nodiscard]] std::string waypoint(const tocsin_msgs::msg::MissionStatus& mission,
                                   const char* between);
[[nodiscard]] std::string place_text(const Place& place);

/// The other site that the vehicle speaks with at `now`; empty when that is not told lately.
[[nodiscard]] std::optional<Heard<OtherSite>> elsewhere(const ViewState& state, Time now,
                                                        const FreshnessLimits& limits);
/// Of a full one; empty when it is not.
[[nodiscard]] std::string trouble(const Disk& disk);

// `age`: of the value.
[[nodiscard]] terminal::Line words(const Disk& disk, Duration age);
[[nodiscard]] terminal::Line words(const OtherSite& site, Duration age);
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::SafetyStatus& status, Duration age);
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::MissionStatus& mission, Duration age);
[[nodiscard]] terminal::Line words(const Place& place, Duration age);
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::NavigationStatus& navigation,
                                   Duration age);
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::NetworkQuality& quality, Duration age);
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::TransmissionState& state, Duration age);

}  // namespace tocsin::view
