// SPDX-License-Identifier: Apache-2.0
#include "link_table.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "foundation/freshness.hpp"
#include "link_state_text/link_state_text.hpp"
#include "terminal/aged.hpp"

namespace tocsin::top {
namespace {

constexpr Duration way_forgotten_after = std::chrono::minutes(10);

}  // namespace

void LinkTable::add(const tocsin_msgs::msg::LinkState& state, Time now) {
  entries_[state.role()] = {state, now};
  for (auto it = entries_.begin(); it != entries_.end();) {
    it = now - it->second.at > way_forgotten_after ? entries_.erase(it) : std::next(it);
  }
}

std::vector<terminal::Line> LinkTable::lines(Time now) const {
  std::vector<terminal::Line> lines;
  for (const auto& [role, entry] : entries_) {
    terminal::Line line{{fmt::format("{:<10}", link_text::direction(role))}};
    for (terminal::Span& span : terminal::aged(link_text::words(entry.state), now - entry.at)) {
      line.push_back(std::move(span));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<terminal::Line> LinkTable::classes(Time now, std::size_t width) const {
  std::vector<tocsin_msgs::msg::LinkState> fresh;
  for (const auto& [role, entry] : entries_) {
    if (freshness(now - entry.at) == Freshness::fresh) fresh.push_back(entry.state);
  }
  return link_text::table(fresh, width);
}

}  // namespace tocsin::top
