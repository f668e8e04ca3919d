// SPDX-License-Identifier: Apache-2.0
#include "live_view/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

const char* const green = "\x1b[32m";
const char* const red = "\x1b[31m";
const char* const bold = "\x1b[1m";
const char* const plain = "\x1b[0m";

std::string paint(const std::string& text, const char* with, bool colour) {
  return colour ? with + text + plain : text;
}

std::string number(double value, int digits, const char* unit) {
  if (std::isnan(value)) return "-";
  return fmt::format("{:.{}f}{}{}", value, digits, *unit == '\0' ? "" : " ", unit);
}

std::string bar(double percent) {
  constexpr int width = 10;
  const double share = std::isnan(percent) ? 0 : std::clamp(percent, 0.0, 100.0) / 100;
  const auto filled = static_cast<std::size_t>(std::lround(share * width));
  return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "]";
}

std::string mission_line(const ViewState& state) {
  if (!state.mission) return "Mission   no status yet";
  const auto& mission = *state.mission;
  const auto elapsed = static_cast<long>(mission.elapsed_s());
  return fmt::format("Mission   {}: {}, waypoint {} of {}, {}:{:02} min, {} goals sent",
                     mission.mission(), mission.state(),
                     std::min(mission.waypoint() + 1, mission.waypoints()), mission.waypoints(),
                     elapsed / 60, elapsed % 60, mission.goals_sent());
}

std::string vehicle_line(const ViewState& state) {
  if (!state.located) return "Vehicle   no location yet";
  std::string text = fmt::format("Vehicle   at ({:.2f}, {:.2f}) m, {:.1f} s ago", state.x_m,
                                 state.y_m, state.location_age_s);
  if (state.navigation) {
    text += fmt::format(", {}, {} to go", state.navigation->state(),
                        number(state.navigation->distance_m(), 1, "m"));
  }
  return text;
}

std::string link_line(const ViewState& state) {
  if (!state.quality) return "Link      no measurement yet";
  const auto& quality = *state.quality;
  return fmt::format("Link      PER {}, RTT {}, signal {}, link quality {}",
                     number(quality.per_percent(), 1, "%"), number(quality.rtt_mean_ms(), 1, "ms"),
                     number(quality.signal_dbm(), 0, "dBm"),
                     number(quality.quality_percent(), 0, "%"));
}

std::string decision_line(const char* role,
                          const std::optional<tocsin_msgs::msg::TransmissionState>& decided,
                          bool colour) {
  if (!decided) return fmt::format("{:<10}no decision yet", role);
  const auto& state = *decided;
  const std::string word = state.active() ? "ACTIVE " : "PASSIVE";
  std::string text =
      fmt::format("{:<10}{} by {} ({}) QNI {} {} {}/{}", role,
                  paint(word, state.active() ? green : red, colour), state.policy(), state.reason(),
                  number(state.qni(), 1, ""), bar(state.qni()), number(state.statistic(), 1, ""),
                  number(state.threshold(), 1, ""));
  if (!state.active()) text += fmt::format(", resumes in {}", number(state.deadline_s(), 0, "s"));
  return text;
}

std::string traffic_row(const TrafficRow& row, bool colour) {
  const double share = row.sent == 0
                           ? std::nan("")
                           : 100.0 * static_cast<double>(std::min(row.received, row.sent)) /
                                 static_cast<double>(row.sent);
  const std::string paused = row.paused ? paint("PAUSED", red, colour) : "      ";
  return fmt::format("{:<30} {:<9} {:>6.1f}/s {:>8} {:>6}/{:<6} {:>6}  {} {:>7}", row.topic,
                     row.traffic_class, row.rate_hz, number(row.age_s, 1, "s"), row.received,
                     row.sent, number(share, 0, "%"), paused, row.dropped);
}

}  // namespace

std::string page(const ViewState& state, bool colour) {
  std::string text = paint("Tocsin", bold, colour) + "\n";
  for (const std::string& line :
       {mission_line(state), vehicle_line(state), link_line(state),
        decision_line("Vehicle", state.uxv, colour), decision_line("Station", state.gcs, colour)}) {
    text += line + "\n";
  }
  text +=
      "\n" +
      paint(fmt::format("{:<30} {:<9} {:>8} {:>8} {:>13} {:>6}  {:<6} {:>7}", "from the vehicle",
                        "class", "rate", "age", "received/sent", "", "gate", "dropped"),
            bold, colour) +
      "\n";
  for (const TrafficRow& row : state.traffic) text += traffic_row(row, colour) + "\n";
  return text;
}

std::string summary_line(const ViewState& state) {
  std::string text;
  if (state.mission) {
    text += fmt::format("waypoint {}/{} {}",
                        std::min(state.mission->waypoint() + 1, state.mission->waypoints()),
                        state.mission->waypoints(), state.mission->state());
  }
  if (state.located) text += fmt::format("  at ({:.2f}, {:.2f})", state.x_m, state.y_m);
  if (state.uxv) {
    text += fmt::format("  QNI {}  vehicle {} ({})", number(state.uxv->qni(), 1, ""),
                        state.uxv->active() ? "active" : "passive", state.uxv->reason());
  }
  if (state.gcs) {
    text += fmt::format("  station {} ({})", state.gcs->active() ? "active" : "passive",
                        state.gcs->reason());
  }
  return text.empty() ? "nothing heard yet" : text;
}

}  // namespace tocsin
