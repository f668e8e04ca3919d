// SPDX-License-Identifier: Apache-2.0
#include "words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "emergency_stop_input/hindrances.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"

namespace tocsin::view {

using terminal::Line;
using terminal::Span;
using terminal::Style;

namespace {

std::string bar(double percent) {
  constexpr int width = 10;
  const double share = std::isnan(percent) ? 0 : std::clamp(percent, 0.0, 100.0) / 100;
  const auto filled = static_cast<std::size_t>(std::lround(share * width));
  return " [" + std::string(filled, '#') + std::string(width - filled, '.') + "]";
}

/// Minutes and seconds; `-` for what is no such time.
std::string minutes(double elapsed_s) {
  if (!(elapsed_s >= 0 && elapsed_s < 1e9)) return "-";
  const auto whole_s = static_cast<long>(elapsed_s);
  return fmt::format("{}:{:02} min", whole_s / 60, whole_s % 60);
}

/// What the policy compares; a policy without a threshold has an infinite one.
std::string rule_text(const tocsin_msgs::msg::TransmissionState& state) {
  const std::string statistic = number(state.statistic(), 1, "");
  return std::isfinite(state.threshold()) ? statistic + "/" + number(state.threshold(), 1, "")
                                          : statistic;
}

}  // namespace

std::string number(double value, int digits, const char* unit) {
  if (!std::isfinite(value)) return "-";
  return fixed_text(value, digits) + (*unit == '\0' ? "" : " ") + unit;
}

std::string waypoint(const tocsin_msgs::msg::MissionStatus& mission, const char* between) {
  return fmt::format("waypoint {}{}{}", std::min(mission.waypoint() + 1, mission.waypoints()),
                     between, mission.waypoints());
}

std::string place_text(const Place& place) {
  return "at (" + fixed_text(place.x_m, 2) + ", " + fixed_text(place.y_m, 2) + ") m";
}

Line words(const tocsin_msgs::msg::MissionStatus& mission, Duration) {
  return {{mission.mission() + ": ", Style::plain, 3},
          {mission.state()},
          {", " + waypoint(mission, " of "), Style::plain, 1},
          {", " + minutes(mission.elapsed_s()), Style::plain, 2},
          {fmt::format(", {} goals sent", mission.goals_sent()), Style::plain, 4}};
}

Line words(const Place& place, Duration) { return {{place_text(place)}}; }

Line words(const tocsin_msgs::msg::NavigationStatus& navigation, Duration) {
  const std::string reason = printable(navigation.reason());
  return {{", " + navigation.state(), Style::plain, 1},
          {reason.empty() ? "" : ": " + reason, Style::plain, 2},
          {", " + number(navigation.distance_m(), 1, "m") + " to go", Style::plain, 2}};
}

Line words(const tocsin_msgs::msg::NetworkQuality& quality, Duration) {
  return {{"PER " + number(quality.per_percent(), 1, "%")},
          {", RTT " + number(quality.rtt_mean_ms(), 1, "ms"), Style::plain, 2},
          {", signal " + number(quality.signal_dbm(), 0, "dBm"), Style::plain, 1},
          {", link quality " + number(quality.quality_percent(), 0, "%"), Style::plain, 3},
          {", probes " + number(static_cast<double>(quality.probe_bytes()) / 1000, 0, "kB"),
           Style::plain, 4}};
}

Line words(const tocsin_msgs::msg::TransmissionState& state, Duration age) {
  Line words{{state.active() ? "ACTIVE " : "PASSIVE", state.active() ? Style::good : Style::bad},
             {" by " + state.policy(), Style::plain, 4},
             {" (" + state.reason() + ")", Style::plain, 3},
             {" QNI " + number(state.qni(), 1, ""), Style::plain, 1},
             {bar(state.qni()), Style::plain, 5},
             {" " + rule_text(state), Style::plain, 6}};
  if (!state.active()) {
    const double left_s = std::max(0.0, state.deadline_s() - to_seconds(age));
    const double shown_s = std::isnan(state.deadline_s()) ? std::nan("") : left_s;
    words.push_back({", resumes in " + number(shown_s, 0, "s"), Style::plain, 2});
  }
  return words;
}

std::optional<Heard<OtherSite>> elsewhere(const ViewState& state, Time now,
                                          const FreshnessLimits& limits) {
  const auto& site = state.other_site;
  return site && freshness(now - site->at, limits) == Freshness::fresh ? site : std::nullopt;
}

std::string trouble(const Disk& disk) {
  return disk.is_full() ? "FULL: recordings and logs are lost" : "";
}

Line words(const Disk& disk, Duration) { return {{trouble(disk), Style::bad}}; }

Line words(const OtherSite& site, Duration) {
  return {{"the vehicle speaks with another one, " + printable(site.name), Style::bold}};
}

Line words(const tocsin_msgs::msg::SafetyStatus& status, Duration) {
  const std::string text = joined(hindrances(status));
  return {text.empty() ? Span{"nothing hinders"} : Span{text, Style::bad}};
}

}  // namespace tocsin::view
