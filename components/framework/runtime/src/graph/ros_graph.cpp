// SPDX-License-Identifier: Apache-2.0
#include "graph/ros_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "idl_support/encode.hpp"
#include "ros_idl/rmw_dds_common.hpp"

namespace tocsin {
namespace {

namespace wide = rmw_dds_common::humble;
namespace narrow = rmw_dds_common::msg;

const std::string hash_key = "typehash=";
const std::string own_mark = "tocsingraph=1;";

template <class WireGid>
WireGid wire_of(const Gid& gid) {
  WireGid wire;
  std::copy(gid.begin(), gid.end(), wire.data().begin());
  return wire;
}

/// Nothing when what a gid of ours has no room for is not zero.
template <class WireGid>
std::optional<Gid> gid_of(const WireGid& wire) {
  Gid gid;
  const auto rest = wire.data().begin() + static_cast<std::ptrdiff_t>(gid.size());
  std::copy(wire.data().begin(), rest, gid.begin());
  const bool zero = std::all_of(rest, wire.data().end(), [](auto byte) { return byte == 0; });
  return zero ? std::optional(gid) : std::nullopt;
}

template <class Sample, class Node, class WireGid>
Sample sample_of(const ParticipantNodes& participant) {
  Sample sample;
  sample.gid(wire_of<WireGid>(participant.participant));
  for (const GraphNode& node : participant.nodes) {
    Node one;
    one.node_namespace(node.ros_namespace);
    one.node_name(node.name);
    for (const Gid& gid : node.readers) one.reader_gid_seq().push_back(wire_of<WireGid>(gid));
    for (const Gid& gid : node.writers) one.writer_gid_seq().push_back(wire_of<WireGid>(gid));
    sample.node_entities_info_seq().push_back(std::move(one));
  }
  return sample;
}

template <class Sequence>
bool take(const Sequence& wire, std::vector<Gid>& gids) {
  for (const auto& one : wire) {
    const auto gid = gid_of(one);
    if (!gid) return false;
    gids.push_back(*gid);
  }
  return true;
}

/// The bytes as a Sample, if they are exactly the bytes of one.
template <class Sample>
std::optional<ParticipantNodes> decoded(const std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t most_padding = 3;
  const TypeInfo& type = type_info<Sample>();
  Sample sample;
  if (!type.deserialize(bytes.data(), bytes.size(), &sample)) return std::nullopt;
  const std::size_t size = type.serialized_size(&sample);
  if (size > bytes.size() || bytes.size() - size > most_padding) return std::nullopt;
  const auto participant = gid_of(sample.gid());
  if (!participant) return std::nullopt;
  ParticipantNodes result{*participant, {}};
  for (const auto& one : sample.node_entities_info_seq()) {
    GraphNode node{one.node_namespace(), one.node_name()};
    if (!take(one.reader_gid_seq(), node.readers)) return std::nullopt;
    if (!take(one.writer_gid_seq(), node.writers)) return std::nullopt;
    result.nodes.push_back(std::move(node));
  }
  return result;
}

}  // namespace

std::string text_of(const Gid& gid) {
  std::string text;
  for (const std::uint8_t byte : gid)
    text += fmt::format("{}{:02x}", text.empty() ? "" : ".", byte);
  return text;
}

bool operator==(const GraphNode& one, const GraphNode& other) {
  return std::tie(one.ros_namespace, one.name, one.readers, one.writers) ==
         std::tie(other.ros_namespace, other.name, other.readers, other.writers);
}

std::vector<std::uint8_t> encode(const ParticipantNodes& nodes, GidSize size) {
  if (size == GidSize::bytes_24) {
    const auto sample =
        sample_of<wide::ParticipantEntitiesInfo, wide::NodeEntitiesInfo, wide::Gid>(nodes);
    return encode(type_info<wide::ParticipantEntitiesInfo>(), &sample);
  }
  const auto sample =
      sample_of<narrow::ParticipantEntitiesInfo, narrow::NodeEntitiesInfo, narrow::Gid>(nodes);
  return encode(type_info<narrow::ParticipantEntitiesInfo>(), &sample);
}

std::optional<ParticipantNodes> decode_nodes(const std::vector<std::uint8_t>& bytes) {
  if (auto nodes = decoded<wide::ParticipantEntitiesInfo>(bytes)) return nodes;
  return decoded<narrow::ParticipantEntitiesInfo>(bytes);
}

GidSize gid_size_for(const std::vector<std::string>& user_data) {
  bool older = false;
  for (const std::string& one : user_data) {
    if (one.find(own_mark) != std::string::npos) continue;
    if (one.find(hash_key) != std::string::npos) return GidSize::bytes_16;
    older = true;
  }
  return older ? GidSize::bytes_24 : GidSize::bytes_16;
}

std::optional<GidSize> gid_size_of_environment() {
  const char* const text = std::getenv("ROS_DISTRO");
  const std::string distro = text == nullptr ? "" : text;
  if (distro.empty()) return std::nullopt;
  const bool older = distro == "humble" || distro == "galactic" || distro == "foxy";
  return older ? GidSize::bytes_24 : GidSize::bytes_16;
}

const std::string& discovery_user_data() {
  static const std::string announced =
      hash_key + type_info<narrow::ParticipantEntitiesInfo>().ros_hash + ";" + own_mark;
  return announced;
}

std::vector<GraphNode> LocalNodes::all() const {
  std::vector<GraphNode> nodes;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [name, ends] : nodes_) {
    GraphNode node{namespace_, name};
    for (const auto& one : ends) {
      const auto& [end, gid] = one.first;
      (end == End::reader ? node.readers : node.writers).push_back(gid);
    }
    nodes.push_back(std::move(node));
  }
  for (const std::string& name : shown_) {
    if (nodes_.count(name) == 0) nodes.push_back({namespace_, name});
  }
  std::sort(nodes.begin(), nodes.end(),
            [](const auto& one, const auto& other) { return one.name < other.name; });
  return nodes;
}

void LocalNodes::show(std::set<std::string> nodes) {
  nodes.erase("");
  const std::lock_guard<std::mutex> lock(mutex_);
  if (nodes == shown_) return;
  ++changes_;
  shown_ = std::move(nodes);
}

void LocalNodes::count(const std::string& node, End end, const Gid& gid, int change) {
  if (node.empty()) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  ++changes_;
  auto& ends = nodes_[node];
  if ((ends[{end, gid}] += change) <= 0) ends.erase({end, gid});
  if (ends.empty()) nodes_.erase(node);
}

}  // namespace tocsin
