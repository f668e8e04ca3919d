// SPDX-License-Identifier: Apache-2.0
#include "live_view/traffic_table.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tocsin {
namespace {

/// Rank of a class in the table; unknown ones come last.
std::size_t rank(const std::string& traffic_class) {
  constexpr std::array<const char*, 3> order{"critical", "high", "low"};
  const auto* found = std::find(order.begin(), order.end(), traffic_class);
  return static_cast<std::size_t>(found - order.begin());
}

}  // namespace

void TrafficTable::on_sample(const std::string& topic, Time now) {
  Entry& entry = entries_[topic];
  entry.recent.push_back(now);
  entry.last = now;
  entry.heard = true;
  ++entry.received_total;
}

/// Both counts of a topic begin anew, so that they cover the same time.
void TrafficTable::restart(Entry& entry) {
  entry.received_before = entry.received_total;
  for (auto& [process, writer] : entry.writers) writer.sent_before = writer.sent;
}

void TrafficTable::on_report(const tocsin_msgs::msg::TrafficReport& report) {
  for (const auto& topic : report.topics()) {
    Entry& entry = entries_[topic.topic()];
    const bool is_new = entry.writers.count(report.process()) == 0;
    Writer& writer = entry.writers[report.process()];
    const bool restarted = topic.sent() < writer.sent;
    writer.sent = topic.sent();
    writer.dropped = topic.dropped();
    if (is_new || restarted) restart(entry);
    entry.row.topic = topic.topic();
    entry.row.traffic_class = topic.traffic_class();
    entry.row.paused = topic.paused();
  }
}

std::vector<TrafficRow> TrafficTable::rows(Time now) {
  std::vector<TrafficRow> all;
  for (auto& [name, entry] : entries_) {
    while (!entry.recent.empty() && now - entry.recent.front() > window) entry.recent.pop_front();
    if (entry.writers.empty()) continue;
    TrafficRow row = entry.row;
    for (const auto& [process, writer] : entry.writers) {
      row.sent += writer.sent - writer.sent_before;
      row.dropped += writer.dropped;
    }
    row.rate_hz = static_cast<double>(entry.recent.size()) / to_seconds(window);
    row.age_s =
        entry.heard ? to_seconds(now - entry.last) : std::numeric_limits<double>::quiet_NaN();
    row.received = entry.received_total - entry.received_before;
    all.push_back(row);
  }
  std::stable_sort(all.begin(), all.end(), [](const TrafficRow& a, const TrafficRow& b) {
    return rank(a.traffic_class) < rank(b.traffic_class);
  });
  return all;
}

}  // namespace tocsin
