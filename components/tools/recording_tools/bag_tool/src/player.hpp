// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bag/bag_reader.hpp"
#include "pace.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "topic_choice.hpp"

namespace tocsin::bag_tool {

struct PlayOrder {
  std::string bag;
  TopicWishes topics;
  std::map<std::string, std::string> remap;  ///< recorded name to the one that is written
  double rate = 1;
  bool loop = false;
  double start_offset_s = 0;
  double duration_s = std::numeric_limits<double>::infinity();  ///< [s] of recorded time
  double delay_s = 0;                                           ///< before the first message
  double clock_hz = 0;                                          ///< of /clock; 0: not written
};

/// `/a:=/b` as an entry of PlayOrder::remap. Throws ConfigError for what is none.
[[nodiscard]] std::pair<std::string, std::string> remapping(const std::string& text);

/// The bytes of a rosgraph_msgs/msg/Clock.
[[nodiscard]] std::vector<std::uint8_t> encoded_clock(std::int64_t ns);

/// Writes the messages of a bag to a host's domain again, with the QoS that their writers offered.
class Player {
 public:
  /// Throws ConfigError when it is no bag, or holds none of the topics. `graph` must outlive it.
  Player(HostGraph& graph, const PlayOrder& order);

  /// Plays to the end, or until a signal comes. Returns the number of messages written.
  std::uint64_t run();
  /// Messages that the middleware refused.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  void make_writings();
  void play_once();
  /// Waits until `due`, and writes the clock meanwhile.
  void wait(const Pace& pace, Time due);

  HostGraph& graph_;
  const PlayOrder order_;
  const TopicChoice choice_;
  bag::BagReader reader_;
  bag::Selection selection_;
  std::vector<std::unique_ptr<RawWriting>> writings_;  ///< by topic; empty: it is not played
  std::unique_ptr<RawWriting> clock_;
  Time next_clock_{};
  std::vector<std::uint8_t> bytes_;
  std::uint64_t written_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace tocsin::bag_tool
