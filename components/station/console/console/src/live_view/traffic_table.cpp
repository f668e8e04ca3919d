// SPDX-License-Identifier: Apache-2.0
#include "live_view/traffic_table.hpp"

#include <algorithm>

#include "foundation/traffic_class.hpp"

namespace tocsin {
namespace {

/// Rank of a class in the table; unknown ones come last.
std::size_t rank(const std::string& traffic_class) {
  const auto known = traffic_class_of(traffic_class);
  return known ? static_cast<std::size_t>(*known) : traffic_classes.size();
}

}  // namespace

void TrafficTable::on_reader(const std::string& topic, const TopicReader& reader) {
  entries_[topic].reader = reader;
}

void TrafficTable::on_sample(const std::string& topic, Time now) {
  Entry& entry = entries_[topic];
  entry.recent.push_back(now);
  entry.last = now;
  ++entry.received_total;
}

/// Both counts of a topic begin anew, so that they cover the same time.
void TrafficTable::restart(Entry& entry) {
  entry.received_before = entry.received_total;
  for (auto& [process, writer] : entry.writers) writer.sent_before = writer.sent;
}

void TrafficTable::on_report(const tocsin_msgs::msg::TrafficReport& report, Time now) {
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
    if (topic.plain_bytes() > 0) {
      entry.row.size =
          static_cast<double>(topic.sent_bytes()) / static_cast<double>(topic.plain_bytes());
    }
    entry.reported = now;
  }
}

std::optional<Time> TrafficTable::reported(const std::string& topic) const {
  const auto found = entries_.find(topic);
  if (found == entries_.end() || found->second.writers.empty()) return std::nullopt;
  return found->second.reported;
}

Counting TrafficTable::counting(const Entry& entry) {
  if (!entry.reader) return Counting::not_read;
  if (entry.received_total == 0 && entry.reader->writers == 0) return Counting::no_match;
  return entry.reader->thins ? Counting::thinned : Counting::counted;
}

TrafficRow TrafficTable::row(const Entry& entry, Time now) {
  TrafficRow row = entry.row;
  for (const auto& [process, writer] : entry.writers) {
    row.sent += writer.sent - writer.sent_before;
    row.dropped += writer.dropped;
  }
  row.counting = counting(entry);
  row.rate_hz = static_cast<double>(entry.recent.size()) / to_seconds(window);
  if (entry.last) row.age = now - *entry.last;
  row.received = entry.received_total - entry.received_before;
  row.report_age = now - entry.reported;
  return row;
}

std::vector<TrafficRow> TrafficTable::rows(Time now) {
  std::vector<TrafficRow> all;
  for (auto& [name, entry] : entries_) {
    while (!entry.recent.empty() && now - entry.recent.front() > window) entry.recent.pop_front();
    if (!entry.writers.empty()) all.push_back(row(entry, now));
  }
  std::stable_sort(all.begin(), all.end(), [](const TrafficRow& a, const TrafficRow& b) {
    return rank(a.traffic_class) < rank(b.traffic_class);
  });
  return all;
}

}  // namespace tocsin
