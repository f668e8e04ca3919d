// SPDX-License-Identifier: Apache-2.0
#include "report/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "foundation/printable.hpp"

namespace tocsin::report {
namespace {

constexpr std::size_t longest_name = 32;  // of what is recorded; the width of its column

std::string name_text(const std::string& name) { return printable(name, longest_name); }

/// A number in a column of seven, "-" when there is none.
std::string cell(double value) {
  if (!std::isfinite(value)) return fmt::format("{:>7}", "-");
  if (std::fabs(value) >= 1e6) return fmt::format("{:>7.0e}", value);
  return fmt::format("{:>7.{}f}", value, std::fabs(value) < 100 ? 1 : 0);
}

std::string spread_cells(const Spread& spread, double factor) {
  return cell(spread.median * factor) + cell(spread.p99 * factor);
}

std::string mission_text(const Mission& mission) {
  if (mission.state.empty()) return "Mission   none was recorded\n";
  const int reached = mission.state == "done" ? mission.waypoints : mission.waypoint;
  return fmt::format("Mission   {}: {}, {} of {} waypoints in {} s, {} goals sent\n",
                     name_text(mission.name), name_text(mission.state), reached, mission.waypoints,
                     fixed_text(mission.elapsed_s, 1), mission.goals_sent);
}

std::string table_text(const char* title, const std::vector<Traffic>& rows) {
  std::string text =
      fmt::format("\n{:<32}{:>9}{:>12}{:>7}{:>7}{:>14}{:>14}{:>9}\n", title, "received",
                  "backfilled", "lost", "lost", "latency [ms]", "age [ms]", "kB/s");
  text += fmt::format("{:<32}{:>9}{:>12}{:>7}{:>7}{:>14}{:>14}{:>9}\n", "", "live", "", "", "%",
                      "median    p99", "median    p99", "");
  for (const Traffic& row : rows) {
    text += fmt::format("{:<32}{:>9}{:>12}{:>7}", name_text(row.name), row.received, row.backfilled,
                        row.lost);
    text += cell(row.lost_percent()) + spread_cells(row.latency_s, 1000) +
            spread_cells(row.age_s, 1000) + "  " + cell(row.bytes_per_s / 1000) + "\n";
  }
  return text;
}

std::string half_row(const Traffic* traffic) {
  const double none = std::nan("");
  if (traffic == nullptr)
    return spread_cells({none, none}, 1) + spread_cells({none, none}, 1) + cell(none);
  return spread_cells(traffic->latency_s, 1000) + spread_cells(traffic->age_s, 1000) +
         cell(traffic->lost_percent());
}

const Traffic* find(const Summary& summary, const std::string& name) {
  const auto found = std::find_if(summary.classes.begin(), summary.classes.end(),
                                  [&](const Traffic& traffic) { return traffic.name == name; });
  return found == summary.classes.end() ? nullptr : &*found;
}

}  // namespace

std::string to_text(const Summary& summary) {
  std::string text = mission_text(summary.mission);
  text += fmt::format("Policy    {}: {} pauses, {} s of {} s paused, the longest {} s\n",
                      name_text(summary.policy), summary.pauses, fixed_text(summary.paused_s, 1),
                      fixed_text(summary.length_s, 1), fixed_text(summary.longest_pause_s, 1));
  text += fmt::format("Network   QNI median {}, lowest {}; PER median {} %, p99 {} %\n",
                      fixed_text(summary.qni_median, 1), fixed_text(summary.qni_min, 1),
                      fixed_text(summary.per_percent.median, 1),
                      fixed_text(summary.per_percent.p99, 1));
  text += fmt::format("Poor      {} s with a QNI below {}\n", fixed_text(summary.poor_s, 1),
                      fixed_text(poor_below_qni, 0));
  return text + table_text("Class", summary.classes) + table_text("Topic", summary.topics);
}

std::string compare_text(const Summary& first, const Summary& second) {
  std::string text;
  for (const Summary* summary : {&first, &second}) {
    text += fmt::format("{:<10}", name_text(summary->policy)) +
            mission_text(summary->mission).substr(10);
  }
  text +=
      fmt::format("\n{:<19}| {:<36}| {}\n", "", name_text(first.policy), name_text(second.policy));
  const char* heads = "latency [ms]      age [ms]   lost";
  text += fmt::format("{:<19}|  {} |  {}\n", "", heads, heads);
  const char* columns = " median    p99 median    p99      %";
  text += fmt::format("{:<19}|{}  |{}\n", "", columns, columns);
  std::vector<std::string> names;
  for (const Traffic& traffic : first.classes) names.push_back(traffic.name);
  for (const Traffic& traffic : second.classes) {
    if (find(first, traffic.name) == nullptr) names.push_back(traffic.name);
  }
  for (const std::string& name : names) {
    text += fmt::format("{:<19}|", name_text(name)) + half_row(find(first, name)) + "  |" +
            half_row(find(second, name)) + "\n";
  }
  return text;
}

}  // namespace tocsin::report
