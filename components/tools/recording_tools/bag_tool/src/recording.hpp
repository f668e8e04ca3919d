// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bag/bag_writer.hpp"
#include "record_queue.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "topic_choice.hpp"

namespace tocsin::bag_tool {

struct RecordOrder {
  std::string output;
  TopicWishes topics;
  bag::BagOptions options;
  bool discovery = true;  ///< topics that appear later, too
  double polling_interval_s = 0.1;
  std::size_t cache_bytes = 100'000'000;  ///< [byte] that may wait for the disk
};

/// Records topics of a host's domain into a bag, those that are there and those that appear.
class Recording {
 public:
  /// Throws ConfigError when the bag cannot be made or an expression is none. `graph` must outlive
  /// it.
  Recording(HostGraph& graph, const RecordOrder& order);

  /// Records until a signal comes; prints what it subscribes to, and what is lost.
  void run();
  [[nodiscard]] std::uint64_t messages() const { return messages_; }
  /// Messages for which there was no room in memory or on the disk.
  [[nodiscard]] std::uint64_t lost() const { return queue_.dropped() + writer_.lost(); }
  [[nodiscard]] std::size_t topics() const { return topics_; }

 private:
  void look_for_topics();
  void subscribe(const std::string& name, const std::vector<const GraphEnd*>& writers);
  void write_what_came(Duration patience);
  void tell_loss();

  HostGraph& graph_;
  const RecordOrder order_;
  const TopicChoice choice_;
  bag::BagWriter writer_;
  RecordQueue queue_;
  std::map<std::string, std::unique_ptr<RawReading>> readings_;  ///< by ROS name
  std::size_t topics_ = 0;
  std::uint64_t messages_ = 0;
  std::uint64_t told_lost_ = 0;
};

}  // namespace tocsin::bag_tool
