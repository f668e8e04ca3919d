// SPDX-License-Identifier: Apache-2.0
#include "report/plot.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/draw.hpp"
#include "report/summary.hpp"

namespace tocsin::report {
namespace {

using nlohmann::json;

/// A line over the seconds since the run began, of those of `points` that `value` gives.
template <class Points, class Value>
json line(const std::string& name, const Points& points, double begin_s, Value value) {
  json x = json::array();
  json y = json::array();
  for (const auto& point : points) {
    x.push_back(point.time_s - begin_s);
    y.push_back(value(point));
  }
  return {{"name", name}, {"x", x}, {"y", y}};
}

/// [kbit/s] of all sides, sorted.
std::vector<double> capacities(const Recording& recording) {
  std::vector<double> all;
  for (const auto& [role, states] : recording.routers) {
    for (const RouterState& state : states) {
      if (std::isfinite(state.capacity_bytes_per_s))
        all.push_back(state.capacity_bytes_per_s * 8e-3);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// [ms] of backlog: how high the time on the second path is shaded.
constexpr double second_mark = 50;

/// The capacity of the sides that measured it, as pictures let the vehicle do, and the backlog of
/// both. A few high estimates, as of a run's first packets, do not flatten the scale: it ends at
/// twice the 95th percentile where the highest is more, and the label says what is cut.
json link_panel(const Recording& recording) {
  const auto by_second = [](const RouterState& one) { return one.by_second; };
  json lines = json::array();
  for (const auto& [role, states] : recording.routers) {
    const std::string side = to_string(role);
    lines.push_back(line(side + " capacity", states, recording.begin_s,
                         [](const RouterState& one) { return one.capacity_bytes_per_s * 8e-3; }));
    if (std::any_of(states.begin(), states.end(), by_second)) {
      json second = line(side + " by its second path", states, recording.begin_s,
                         [](const RouterState& one) { return one.by_second ? second_mark : 0; });
      second["style"] = "area";
      second["right"] = true;
      lines.push_back(second);
    }
    json backlog = line(side + " backlog", states, recording.begin_s,
                        [](const RouterState& one) { return one.backlog_s * 1e3; });
    backlog["right"] = true;
    lines.push_back(backlog);
  }
  json panel{{"y", "capacity [kbit/s]"}, {"right", "backlog [ms]"}, {"range", {0, nullptr}}};
  const std::vector<double> sorted = capacities(recording);
  if (!sorted.empty()) {
    const double shown = 2 * sorted[(sorted.size() - 1) * 95 / 100];
    if (shown > 0 && sorted.back() > shown) {
      panel["range"] = {0, shown};
      panel["y"] = "capacity [kbit/s], to " + std::to_string(std::llround(sorted.back()));
    }
  }
  panel["lines"] = lines;
  return panel;
}

json traffic_panel(const Recording& recording) {
  const double bin_s = rate_bin_s(recording.begin_s, recording.end_s);
  json lines = json::array();
  for (const auto& [link_class, arrivals] : recording.arrivals) {
    json x = json::array();
    json y = json::array();
    for (const double rate : byte_rates(arrivals, recording.begin_s, recording.end_s)) {
      x.push_back((static_cast<double>(x.size()) + 0.5) * bin_s);
      y.push_back(rate * 8e-3);
    }
    lines.push_back({{"name", to_string(link_class)}, {"x", x}, {"y", y}});
  }
  return {{"y", "received [kbit/s]"}, {"range", {0.1, nullptr}}, {"log", true}, {"lines", lines}};
}

}  // namespace

std::string plot_of(const Recording& recording) {
  const std::string policy =
      recording.decisions.empty() ? "" : ", policy " + recording.decisions.back().policy;
  json spans = json::array();
  for (const Interval& pause : pauses_of(recording)) {
    spans.push_back({pause.begin_s - recording.begin_s, pause.end_s - recording.begin_s});
  }
  json panels = json::array();
  panels.push_back(json{{"y", "QNI, PER [%]"},
                        {"range", {0, 100}},
                        {"lines",
                         {line("QNI", recording.decisions, recording.begin_s,
                               [](const Decision& one) { return one.qni; }),
                          line("PER", recording.qualities, recording.begin_s,
                               [](const Quality& one) { return one.per_percent; })}}});
  if (!recording.routers.empty()) panels.push_back(link_panel(recording));
  panels.push_back(traffic_panel(recording));
  const json picture{{"title", "Mission " + recording.mission.name + policy + " (grey: paused)"},
                     {"x", "time [s]"},
                     {"range", {0, recording.end_s - recording.begin_s}},
                     {"spans", spans},
                     {"panels", panels}};
  return picture.dump(-1, ' ', false, json::error_handler_t::replace);
}

void draw_plot(const Recording& recording) { draw(plot_of(recording), recording.folder + "/plot"); }

}  // namespace tocsin::report
