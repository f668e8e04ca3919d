// SPDX-License-Identifier: Apache-2.0
#include "traffic_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "words.hpp"

namespace tocsin::view {
namespace {

using terminal::Style;

/// Received of sent, and its share, as far as they are known.
struct Delivery {
  std::string counts;
  std::string share = "-";
};

Delivery delivery_of(const TrafficRow& row, bool reported) {
  if (row.counting == Counting::not_read) return {"not read here"};
  if (row.counting == Counting::no_match) return {"no writer met"};
  if (!reported) return {fmt::format("{}/-", row.received)};
  Delivery delivery{fmt::format("{}/{}", row.received, row.sent)};
  if (row.counting == Counting::thinned) {
    delivery.share = "thinned";
  } else if (row.sent > 0) {
    const double share =
        static_cast<double>(std::min(row.received, row.sent)) / static_cast<double>(row.sent);
    delivery.share = number(100 * share, 0, "%");
  }
  return delivery;
}

std::string precise_age(Duration age) {
  return age < std::chrono::seconds(10) ? number(to_seconds(age), 1, "s") : age_text(age);
}

void add_row(const TrafficRow& row, const FreshnessLimits& limits, terminal::Table& table) {
  const bool read = row.counting != Counting::not_read;
  const Freshness report = freshness(row.report_age, limits);
  const bool reported = report != Freshness::unknown;
  const bool silent = read && freshness(row.age, limits) != Freshness::fresh;
  const Style mine = silent ? Style::old : Style::plain;
  const Style theirs = report == Freshness::fresh ? mine : Style::old;
  const Delivery delivery = delivery_of(row, reported);
  const bool paused = reported && row.paused;
  table.add({{row.topic, mine},
             {row.traffic_class, mine},
             {read ? fmt::format("{:.1f}/s", row.rate_hz) : "-", mine},
             {row.age ? precise_age(*row.age) : "-", mine},
             {delivery.counts, theirs},
             {delivery.share, theirs},
             {reported && row.size ? number(100 * *row.size, 0, "%") : "-", theirs},
             {paused ? "PAUSED" : "", report == Freshness::fresh ? Style::bad : Style::old},
             {reported ? std::to_string(row.dropped) : "-", theirs}});
}

}  // namespace

std::vector<TrafficRow> idle_last(std::vector<TrafficRow> traffic) {
  std::stable_partition(traffic.begin(), traffic.end(), [](const TrafficRow& row) {
    return row.rate_hz > 0 || row.paused || row.received < row.sent;
  });
  return traffic;
}

std::vector<terminal::Line> traffic_lines(const std::vector<TrafficRow>& traffic,
                                          const FreshnessLimits& limits, std::size_t width) {
  using terminal::Align;
  terminal::Table table({{"from the vehicle"},
                         {"class", Align::left, 4, 8},
                         {"rate", Align::right, 3, 6},
                         {"age", Align::right, 0, 6},
                         {"received/sent", Align::right, 2},
                         {"", Align::right, 1, 5},
                         {"size", Align::right, 6, 5},
                         {"gate", Align::left, 0, 6},
                         {"dropped", Align::right, 5}});
  for (const TrafficRow& row : traffic) add_row(row, limits, table);
  return table.lines(width);
}

}  // namespace tocsin::view
