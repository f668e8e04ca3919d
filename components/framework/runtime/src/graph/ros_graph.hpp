// SPDX-License-Identifier: Apache-2.0
// How processes tell ROS 2 which nodes they have: the topic ros_discovery_info. Pure.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/middleware/host_graph.hpp"

namespace tocsin {

/// All nodes of one participant: what one sample of ros_discovery_info says.
struct ParticipantNodes {
  Gid participant{};
  std::vector<GraphNode> nodes = {};
};

inline constexpr const char* discovery_topic = "ros_discovery_info";
inline constexpr const char* discovery_type = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

/// The sample with its encapsulation header.
[[nodiscard]] std::vector<std::uint8_t> encode(const ParticipantNodes& nodes, GidSize size);
/// Of either size, which the bytes tell; nothing when they are neither.
[[nodiscard]] std::optional<ParticipantNodes> decode_nodes(const std::vector<std::uint8_t>& bytes);

/// Which size the peers understand. `user_data`: of the ends of ros_discovery_info that others have
/// announced. Since Iron they tell a type hash there; before, nothing. One participant cannot serve
/// both; of both, the newer are served. Without peers: 16.
[[nodiscard]] GidSize gid_size_for(const std::vector<std::string>& user_data);
/// $ROS_DISTRO, which says it without looking at peers; nothing when it is not set.
[[nodiscard]] std::optional<GidSize> gid_size_of_environment();

/// What our own ends of ros_discovery_info announce, so that they do not count as peers.
[[nodiscard]] const std::string& discovery_user_data();

/// The ends of this process's nodes. Thread-safe.
class LocalNodes {
 public:
  enum class End { reader, writer };
  /// `ros_namespace` without slashes; empty for none.
  explicit LocalNodes(const std::string& ros_namespace) : namespace_("/" + ros_namespace) {}
  /// Several ports of a node may share an end: it has it until each is removed. A node without a
  /// name is none.
  void add(const std::string& node, End end, const Gid& gid) { count(node, end, gid, 1); }
  void remove(const std::string& node, End end, const Gid& gid) { count(node, end, gid, -1); }
  /// These are there too, with ends or without: nodes of others that are reached by this process.
  void show(std::set<std::string> nodes);
  /// By name.
  [[nodiscard]] std::vector<GraphNode> all() const;
  /// Somebody begins or ends to hear of nodes, and may take gids of another size.
  void note_listener() { ++changes_; }
  /// Grows when an end or a listener comes or goes.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

 private:
  void count(const std::string& node, End end, const Gid& gid, int change);
  const std::string namespace_;
  std::atomic<std::uint64_t> changes_{0};
  mutable std::mutex mutex_;
  std::map<std::string, std::map<std::pair<End, Gid>, int>> nodes_;
  std::set<std::string> shown_;
};

}  // namespace tocsin
