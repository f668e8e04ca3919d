// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// Whether what came of a topic is counted here.
enum class Counting {
  counted,   ///< All that came.
  thinned,   ///< The reader's QoS drops some on purpose, so that fewer than sent is no loss.
  no_match,  ///< Nothing came, and the reader has found no writer of this topic.
  not_read,  ///< Nobody reads it here: of what came nothing is known.
};

/// What the view shows of one topic.
struct TrafficRow {
  std::string topic;
  std::string traffic_class;
  Counting counting = Counting::not_read;
  double rate_hz = 0;           ///< samples received in the last 5 s, by second
  std::optional<Duration> age;  ///< since the last sample; empty before the first
  std::uint64_t received = 0;   ///< here, from the first traffic report on
  std::uint64_t sent = 0;       ///< by the other side in the same time
  std::uint64_t dropped = 0;    ///< by its gate, since it started
  bool paused = false;
  Duration report_age{0};      ///< of what the other side told: sent, dropped, paused
  std::optional<double> size;  ///< [0, 1] of its serialised bytes that cross; empty: nothing sent
};

/// How the reader of a topic stands.
struct TopicReader {
  std::optional<int> writers;  ///< of other processes that it is matched with; empty: not known
  bool thins = false;          ///< its QoS has dropped samples
};

/// Joins what the vehicle's traffic reports say was sent with what came here. Pure.
class TrafficTable {
 public:
  /// The topic is read here; without this it counts as not read.
  void on_reader(const std::string& topic, const TopicReader& reader);
  void on_sample(const std::string& topic, Time now);
  /// A report of the other side.
  void on_report(const tocsin_msgs::msg::TrafficReport& report, Time now);
  /// When a writer of the topic last told that it lives; empty when none did.
  [[nodiscard]] std::optional<Time> reported(const std::string& topic) const;
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
    std::optional<TopicReader> reader;
    std::deque<Time> recent;
    std::optional<Time> last;
    Time reported{};
    std::uint64_t received_total = 0;
    std::uint64_t received_before = 0;
  };
  static void restart(Entry& entry);
  static Counting counting(const Entry& entry);
  static TrafficRow row(const Entry& entry, Time now);
  std::map<std::string, Entry> entries_;
};

}  // namespace tocsin
