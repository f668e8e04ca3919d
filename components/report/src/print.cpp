// SPDX-License-Identifier: Apache-2.0
#include "report/print.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace tocsin::report {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  std::array<char, 256> line{};
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(line.data(), line.size(), pattern, arguments);
  va_end(arguments);
  return line.data();
}

/// A number in a column of seven, "-" when there is none.
std::string cell(double value) {
  if (!std::isfinite(value)) return format("%7s", "-");
  return format(std::fabs(value) < 100 ? "%7.1f" : "%7.0f", value);
}

std::string spread_cells(const Spread& spread, double factor) {
  return cell(spread.median * factor) + cell(spread.p99 * factor);
}

std::string mission_text(const Mission& mission) {
  if (mission.state.empty()) return "Mission   none was recorded\n";
  const int reached = mission.state == "done" ? mission.waypoints : mission.waypoint;
  return format("Mission   %s: %s, %d of %d waypoints in %.1f s, %d goals sent\n",
                mission.name.c_str(), mission.state.c_str(), reached, mission.waypoints,
                mission.elapsed_s, mission.goals_sent);
}

std::string table_text(const char* title, const std::vector<Traffic>& rows) {
  std::string text = format("\n%-32s%9s%7s%7s%14s%14s%9s\n%-32s%9s%7s%7s%14s%14s%9s\n", title,
                            "received", "lost", "lost", "latency [ms]", "age [ms]", "kB/s", "", "",
                            "", "%", "median    p99", "median    p99", "");
  for (const Traffic& row : rows) {
    text +=
        format("%-32s%9llu%7llu", row.name.c_str(), static_cast<unsigned long long>(row.received),
               static_cast<unsigned long long>(row.lost));
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
  text += format("Policy    %s: %d pauses, %.1f s of %.1f s paused, the longest %.1f s\n",
                 summary.policy.c_str(), summary.pauses, summary.paused_s, summary.length_s,
                 summary.longest_pause_s);
  text += format("Network   QNI median %.1f, lowest %.1f; PER median %.1f %%, p99 %.1f %%\n",
                 summary.qni_median, summary.qni_min, summary.per_percent.median,
                 summary.per_percent.p99);
  text += format("Poor      %.1f s with a QNI below %.0f\n", summary.poor_s, poor_below_qni);
  return text + table_text("Class", summary.classes) + table_text("Topic", summary.topics);
}

std::string compare_text(const Summary& first, const Summary& second) {
  std::string text;
  for (const Summary* summary : {&first, &second}) {
    text += format("%-10s", summary->policy.c_str()) + mission_text(summary->mission).substr(10);
  }
  text += "\n";
  text +=
      format("%-19s|%-37s|%s\n", "", (" " + first.policy).c_str(), (" " + second.policy).c_str());
  const char* heads = "latency [ms]      age [ms]   lost";
  text += format("%-19s|  %s |  %s\n", "", heads, heads);
  const char* columns = " median    p99 median    p99      %";
  text += format("%-19s|%s  |%s\n", "", columns, columns);
  std::vector<std::string> names;
  for (const Traffic& traffic : first.classes) names.push_back(traffic.name);
  for (const Traffic& traffic : second.classes) {
    if (find(first, traffic.name) == nullptr) names.push_back(traffic.name);
  }
  for (const std::string& name : names) {
    text += format("%-19s|", name.c_str()) + half_row(find(first, name)) + "  |" +
            half_row(find(second, name)) + "\n";
  }
  return text;
}

}  // namespace tocsin::report
