// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bag/bag_writer.hpp"
#include "fetch.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "state_listener.hpp"

namespace tocsin::log_tool {

/// Time, and how to pass it.
struct Waiting {
  std::function<Time()> now;
  std::function<void(Time due)> sleep_until;
};
/// The steady clock; a signal ends a sleep.
[[nodiscard]] Waiting real_waiting();

/// Asks for a part of logs until all of it has crossed, and writes it into a bag, under the topic's
/// own name and with the times at which it was sent.
class Fetching {
 public:
  /// Throws ConfigError when the bag cannot be made. `graph` and `states` must outlive it.
  Fetching(HostGraph& graph, StateListener& states, const tocsin_msgs::msg::LogRequest& request,
           const std::string& output, Waiting waiting = real_waiting());

  /// Until it is done, or a signal comes; prints how far it is. Whether it is done.
  bool run();
  [[nodiscard]] const Fetch& fetch() const { return fetch_; }
  /// Messages in the bag, and those for which it had no room.
  [[nodiscard]] std::uint64_t written() const { return written_; }
  [[nodiscard]] std::uint64_t lost() const { return writer_.lost(); }

 private:
  void ask();
  /// Reads what is backfilled as soon as somebody writes it.
  void look_for_writer();
  void write_what_came();
  [[nodiscard]] bool is_in_range(const RawSample& sample) const;

  HostGraph& graph_;
  StateListener& states_;
  const Waiting waiting_;
  Fetch fetch_;
  bag::BagWriter writer_;
  std::unique_ptr<RawWriting> request_;
  std::size_t topic_ = 0;  ///< in the bag
  std::uint64_t written_ = 0;
  std::mutex mutex_;
  std::vector<RawSample> came_;
  std::unique_ptr<RawReading> reading_;  ///< last: it uses the others
};

}  // namespace tocsin::log_tool
