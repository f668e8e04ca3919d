// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// What the view shows of one topic.
struct TrafficRow {
  std::string topic;
  std::string traffic_class;
  double rate_hz = 0;          ///< samples received in the last 5 s, by second
  double age_s = 0;            ///< since the last sample; NaN before the first
  std::uint64_t received = 0;  ///< here, from the first traffic report on
  std::uint64_t sent = 0;      ///< by the other side in the same time
  std::uint64_t dropped = 0;   ///< by its gate, since it started
  bool paused = false;
};

/// Joins what the vehicle's traffic reports say was sent with what came here. Pure.
class TrafficTable {
 public:
  void on_sample(const std::string& topic, Time now);
  /// A report of the other side.
  void on_report(const tocsin_msgs::msg::TrafficReport& report);
  /// One row for each topic that was reported, in the order of the classes, then by name.
  [[nodiscard]] std::vector<TrafficRow> rows(Time now);

 private:
  static constexpr Duration window = std::chrono::seconds(5);
  /// One process that writes a topic.
  struct Writer {
    std::uint64_t sent_before = 0;
    std::uint64_t sent = 0;
    std::uint64_t dropped = 0;
  };
  struct Entry {
    TrafficRow row;
    std::map<std::string, Writer> writers;
    std::deque<Time> recent;
    Time last{};
    bool heard = false;
    std::uint64_t received_total = 0;
    std::uint64_t received_before = 0;
  };
  static void restart(Entry& entry);
  std::map<std::string, Entry> entries_;
};

}  // namespace tocsin
