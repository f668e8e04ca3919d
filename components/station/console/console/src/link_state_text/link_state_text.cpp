// SPDX-License-Identifier: Apache-2.0
#include "link_state_text/link_state_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "foundation/printable.hpp"
#include "foundation/role.hpp"
#include "foundation/traffic_class.hpp"

namespace tocsin::link_text {
namespace {

using terminal::Line;
using terminal::Style;
using tocsin_msgs::msg::LinkClass;
using tocsin_msgs::msg::LinkState;

/// A sample that waits longer is late (LinkClass::late).
constexpr double late_after_s = 0.25;

std::string number(double value, int digits, const char* unit) {
  if (!std::isfinite(value)) return "-";
  return fixed_text(value, digits) + unit;
}

std::string capacity(const LinkState& state) {
  if (!state.capacity_measured()) return "capacity not measured";
  return number(state.capacity_bytes_per_s() / 1000.0, 0, " kB/s");
}

std::string loss(const LinkState& state) { return number(100.0 * state.loss(), 0, " %"); }

/// "12+4": of class critical and of class high.
template <class Count>
std::string urgent(const LinkState& state, const Count& count) {
  const auto of = [&](TrafficClass wanted) -> std::uint64_t {
    for (const LinkClass& one : state.classes()) {
      if (traffic_class_of(one.traffic_class()) == wanted) return count(one);
    }
    return 0;
  };
  return fmt::format("{}+{}", of(TrafficClass::critical), of(TrafficClass::high));
}

/// Of all bytes since the router started.
std::string share(const LinkState& state, std::uint64_t bytes) {
  if (state.bytes() == 0) return "-";
  return number(100 * static_cast<double>(bytes) / static_cast<double>(state.bytes()), 0, " %");
}

std::uint64_t repair_bytes(const LinkState& state) {
  std::uint64_t bytes = 0;
  for (const LinkClass& one : state.classes()) bytes += one.repair_bytes();
  return bytes;
}

/// Why little or nothing may cross; empty when all is well.
Line trouble(const LinkState& state) {
  if (state.live_peers() == 0) {
    return {{state.silent_peers() > 0 ? "peer SILENT, " : "no peer, ", Style::bad}};
  }
  Line line;
  if (state.silent_peers() > 0) {
    line.push_back({fmt::format("{} SILENT, ", state.silent_peers()), Style::bad});
  }
  if (state.paused()) line.push_back({"PAUSED, ", Style::bad});
  return line;
}

/// Which of two paths is in use, and what the other one does; empty where there is one.
Line paths(const LinkState& state) {
  if (state.paths().size() < 2) return {};
  const bool first = state.paths()[0].chosen();
  Line line{{first ? ", by the first path" : ", by the SECOND path",
             first ? Style::plain : Style::warning, 1}};
  const auto& other = state.paths()[first ? 1 : 0];
  if (other.silent()) line.push_back({", the other SILENT", Style::warning, 1});
  return line;
}

std::uint64_t dropped(const LinkClass& one) {
  return one.dropped_paused() + one.dropped_superseded() + one.dropped_expired() +
         one.dropped_overflow();
}

std::vector<terminal::Cell> row(const LinkState& state, const LinkClass& one) {
  std::vector<terminal::Cell> cells{{direction(state.role()) + " " + one.traffic_class()}};
  for (const std::uint64_t count :
       {one.offered(), one.sent(), one.delivered(), one.late(), one.lost(), one.unwanted(),
        one.repaired(), one.repairs(), dropped(one)}) {
    cells.push_back({std::to_string(count)});
  }
  cells.push_back({std::to_string(one.queue_samples())});
  cells.push_back({number(1000.0 * one.delay_s(), 0, "")});
  return cells;
}

}  // namespace

std::string direction(const std::string& role) {
  const auto sender = role_of(role);
  if (!sender) return "Link";
  return sender == Role::uxv ? "Uplink" : "Downlink";
}

Line words(const LinkState& state) {
  Line line = trouble(state);
  const bool waits = state.backlog_s() > late_after_s;
  const auto add = [&line](std::string text, int rank, Style style = Style::plain) {
    line.push_back({std::move(text), style, rank});
  };
  add(capacity(state), 0);
  for (auto& span : paths(state)) line.push_back(std::move(span));
  add(", backlog " + number(1000.0 * state.backlog_s(), 0, " ms"), 1,
      waits ? Style::warning : Style::plain);
  add(", loss " + loss(state), 2);
  add(", late " + urgent(state, [](const LinkClass& one) { return one.late(); }), 3);
  add(", repaired " + urgent(state, [](const LinkClass& one) { return one.repaired(); }), 5);
  add(", scale " + number(state.scale(), 2, ""), 4);
  add(", repairs " + share(state, repair_bytes(state)), 6);
  add(", acknowledgements " + share(state, state.acknowledgement_bytes()), 7);
  add(", backfill " + share(state, state.backfill_bytes()), 9);
  add(", stop " + share(state, state.stop_bytes()), 8);
  add(", discovery " + share(state, state.discovery_bytes()), 10);
  return line;
}

std::string summary(const LinkState& state) {
  std::string way = direction(state.role());
  way.front() = static_cast<char>(way.front() - 'A' + 'a');
  std::string text = way + " ";
  for (const terminal::Span& span : trouble(state)) text += span.text;
  return text + capacity(state) + ", loss " + loss(state);
}

std::vector<Line> table(const std::vector<LinkState>& states, std::size_t width) {
  if (states.empty()) return {};
  using terminal::Align;
  terminal::Table all({{"LINK"},
                       {"OFFERED", Align::right, 3},
                       {"SENT", Align::right, 5},
                       {"DELIVERED", Align::right, 2},
                       {"LATE", Align::right, 0},
                       {"LOST", Align::right, 0},
                       {"UNWANTED", Align::right, 8},
                       {"REPAIRED", Align::right, 4},
                       {"REPAIRS", Align::right, 6},
                       {"DROPPED", Align::right, 1},
                       {"QUEUE", Align::right, 7},
                       {"DELAY/ms", Align::right, 1}});
  for (const LinkState& state : states) {
    for (const LinkClass& one : state.classes()) {
      if (one.offered() > 0) all.add(row(state, one));
    }
  }
  return all.lines(width);
}

}  // namespace tocsin::link_text
