// SPDX-License-Identifier: Apache-2.0
#include "live_view/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "emergency_stop_input/hindrances.hpp"
#include "link_state_text/link_state_text.hpp"
#include "terminal/aged.hpp"
#include "traffic_page.hpp"
#include "words.hpp"

namespace tocsin {
namespace {

using terminal::aged;
using terminal::Line;
using terminal::Style;

/// The instant of drawing, and how old things may be then.
struct Viewing {
  Time now;
  const FreshnessLimits& limits;
  template <class Value>
  [[nodiscard]] Freshness freshness_of(const Heard<Value>& heard) const {
    return freshness(now - heard.at, limits);
  }
};

void append(Line& line, Line more) {
  std::move(more.begin(), more.end(), std::back_inserter(line));
}

Line labelled(const char* label) { return {{fmt::format("{:<10}", label)}}; }

/// A line about a value, or `nothing` before the first one.
template <class Value>
Line told(const char* label, const std::optional<Heard<Value>>& heard, const char* nothing,
          const Viewing& viewing) {
  Line line = labelled(label);
  if (!heard) {
    line.push_back({nothing});
    return line;
  }
  const Duration age = viewing.now - heard->at;
  append(line, aged(view::words(heard->value, age), age, viewing.limits));
  return line;
}

/// Place and doing of the vehicle: as old as the older of the two. Of a vehicle that was lost,
/// where to look for it.
Line vehicle_line(const ViewState& state, const Viewing& viewing) {
  const auto& place = state.location;
  const auto& doing = state.navigation;
  Line line = told("Vehicle", place, "no location yet", viewing);
  if (!place) return line;
  if (viewing.freshness_of(*place) == Freshness::unknown) {
    line.push_back({", last seen " + view::place_text(place->value), Style::old, 1});
    return line;
  }
  if (!doing || viewing.freshness_of(*doing) == Freshness::unknown) return line;
  const Duration age = viewing.now - std::min(place->at, doing->at);
  Line words = view::words(place->value, age);
  append(words, view::words(doing->value, age));
  line = labelled("Vehicle");
  append(line, aged(std::move(words), age, viewing.limits));
  return line;
}

/// Whether there is more to say of safety than that all is well.
bool safety_matters(const ViewState& state, const Viewing& viewing) {
  if (!state.safety) return false;
  return viewing.freshness_of(*state.safety) != Freshness::fresh ||
         !hindrances(state.safety->value).empty();
}

/// What the router of one side says of its way over the link.
Line way_line(const Heard<tocsin_msgs::msg::LinkState>& heard, const Viewing& viewing) {
  Line line = labelled(link_text::direction(heard.value.role()).c_str());
  append(line, aged(link_text::words(heard.value), viewing.now - heard.at, viewing.limits));
  return line;
}

std::vector<Line> head_lines(const ViewState& state, const Viewing& viewing) {
  std::vector<Line> lines;
  const bool is_full = state.disk && state.disk->value.is_full();
  if (is_full) lines.push_back(told("Disk", state.disk, "", viewing));
  const auto site = view::elsewhere(state, viewing.now, viewing.limits);
  if (site) lines.push_back(told("Site", site, "", viewing));
  if (safety_matters(state, viewing)) lines.push_back(told("Safety", state.safety, "", viewing));
  lines.push_back(told("Mission", state.mission, "no status yet", viewing));
  lines.push_back(vehicle_line(state, viewing));
  lines.push_back(told("Link", state.quality, "no measurement yet", viewing));
  lines.push_back(told("Vehicle", state.uxv, "no decision yet", viewing));
  lines.push_back(told("Station", state.gcs, "no decision yet", viewing));
  for (const auto* const way : {&state.uplink, &state.downlink}) {
    if (*way) lines.push_back(way_line(**way, viewing));
  }
  return lines;
}

}  // namespace

std::vector<Line> page(const ViewState& state, Time now, terminal::Size size,
                       const FreshnessLimits& limits) {
  const Viewing viewing{now, limits};
  const auto [columns, rows] = terminal::known(size);
  std::vector<Line> lines = head_lines(state, viewing);
  lines.resize(std::min(lines.size(), rows));
  const std::size_t room = rows - lines.size();
  const bool fits = state.traffic.size() + 1 <= room;
  std::vector<Line> table =
      view::traffic_lines(fits ? state.traffic : view::idle_last(state.traffic), limits, columns);
  if (lines.size() + table.size() + 2 <= rows) {  // room for what only pleases the eye
    lines.insert(lines.begin(), {{"Tocsin", Style::bold}});
    lines.emplace_back();
  }
  table = terminal::shortened(std::move(table), rows - lines.size(), "topics");
  std::move(table.begin(), table.end(), std::back_inserter(lines));
  for (Line& line : lines) line = terminal::fit(std::move(line), columns);
  return lines;
}

}  // namespace tocsin
