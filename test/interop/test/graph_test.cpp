// SPDX-License-Identifier: Apache-2.0
// Our nodes as another vendor's participant sees them, which decodes ros_discovery_info by the code
// of its own generator: what `ros2 node list` and `ros2 topic info -v` stand on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "cyclone.hpp"
#include "rmw_dds_common.h"
#include "ros_idl/std_msgs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::HasSubstr;

/// One for each test, so that none hears the endpoints of another.
int next_domain() {
  static int last = 108;
  return ++last;
}

struct Unheard : Receiver {
  void receive(const Sample&) override {}
};

/// A process of ours with two nodes, of which both read one topic and one writes it.
class Process {
 public:
  explicit Process(int domain) : bus_(make_fast_dds_bus(options(domain))) {
    const TopicInfo chatter{"chatter", "event", Scope::host};
    const TypeInfo& string = type_info<std_msgs::msg::String>();
    const auto of = [&](const char* node) {
      return Endpoint{chatter, &string, Writers::needed, "", node};
    };
    writer_ = bus_->advertise(of("talker"));
    readers_.push_back(bus_->subscribe(of("talker"), unheard_));
    readers_.push_back(bus_->subscribe(of("listener"), unheard_));
  }
  /// What a container does now and then.
  void update() { bus_->host_control().update_graph(); }

 private:
  static BusOptions options(int domain) {
    BusOptions options;
    options.name = "process";
    options.host_domain = domain;
    options.ros_namespace = "uxv";
    return options;
  }
  Unheard unheard_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Publication> writer_;
  std::vector<std::unique_ptr<Subscription>> readers_;
};

template <class WireGid>
Gid gid_of(const WireGid& wire) {
  Gid gid{};
  std::copy_n(wire.data, gid.size(), gid.begin());
  return gid;
}

template <class Sequence>
std::vector<Gid> gids_of(const Sequence& sequence) {
  std::vector<Gid> gids;
  for (std::uint32_t i = 0; i < sequence._length; ++i) gids.push_back(gid_of(sequence._buffer[i]));
  return gids;
}

using Nodes = std::map<std::string, GraphNode>;

/// A reader of ros_discovery_info by idlc's code for Info, that announces `user_data`.
template <class Info>
class DiscoveryReader {
 public:
  DiscoveryReader(const CycloneParticipant& cyclone, const dds_topic_descriptor_t& type,
                  const std::string& user_data) {
    const auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, 0);
    dds_qset_userdata(qos.get(), user_data.data(), user_data.size());
    reader_ = cyclone.reader(cyclone.topic(type, "ros_discovery_info",
                                           "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"),
                             qos);
  }
  /// Of the last sample.
  [[nodiscard]] Nodes nodes() {
    take_all<Info>(reader_, [this](const Info& info) { last_ = read(info); });
    return last_;
  }

 private:
  static Nodes read(const Info& info) {
    Nodes nodes;
    const auto& all = info.node_entities_info_seq;
    for (std::uint32_t i = 0; i < all._length; ++i) {
      const auto& one = all._buffer[i];
      nodes[one.node_name] = {one.node_namespace, one.node_name, gids_of(one.reader_gid_seq),
                              gids_of(one.writer_gid_seq)};
    }
    return nodes;
  }
  dds_entity_t reader_ = 0;
  Nodes last_;
};

std::string user_data_of(const dds_qos_t* qos) {
  void* value = nullptr;
  std::size_t size = 0;
  if (!dds_qget_userdata(qos, &value, &size) || value == nullptr) return "";
  std::string text(static_cast<const char*>(value), size);
  dds_free(value);
  return text;
}

/// What Cyclone DDS's own discovery has heard of the end of a topic.
struct Heard {
  Gid gid{};
  std::string user_data;
};

/// `kind`: DDS_BUILTIN_TOPIC_DCPSPUBLICATION or ...SUBSCRIPTION.
std::optional<Heard> heard_end(const CycloneParticipant& cyclone, dds_entity_t kind,
                               const std::string& topic) {
  const dds_entity_t reader = checked(dds_create_reader(cyclone.entity(), kind, nullptr, nullptr));
  std::optional<Heard> found;
  take_all<dds_builtintopic_endpoint_t>(reader, [&](const auto& end) {
    if (topic != end.topic_name) return;
    found.emplace();
    std::copy_n(end.key.v, found->gid.size(), found->gid.begin());
    found->user_data = user_data_of(end.qos);
  });
  (void)dds_delete(reader);
  return found;
}

/// User data of all participants that Cyclone DDS has heard.
std::vector<std::string> heard_participants(const CycloneParticipant& cyclone) {
  const dds_entity_t reader = checked(
      dds_create_reader(cyclone.entity(), DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr));
  std::vector<std::string> all;
  take_all<dds_builtintopic_participant_t>(
      reader, [&](const auto& participant) { all.push_back(user_data_of(participant.qos)); });
  (void)dds_delete(reader);
  return all;
}

template <class Info>
void expect_our_nodes(const dds_topic_descriptor_t& type, const std::string& user_data) {
  const int domain = next_domain();
  const CycloneParticipant cyclone(domain);
  DiscoveryReader<Info> sut(cyclone, type, user_data);
  Process process(domain);
  const auto heard = [&](dds_entity_t kind) { return heard_end(cyclone, kind, "rt/uxv/chatter"); };
  Nodes nodes;
  ASSERT_TRUE(eventually([&] {
    process.update();
    nodes = sut.nodes();
    return nodes.size() == 2 && heard(DDS_BUILTIN_TOPIC_DCPSPUBLICATION) &&
           heard(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
  }));
  const auto writer = heard(DDS_BUILTIN_TOPIC_DCPSPUBLICATION);
  const auto reader = heard(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
  EXPECT_EQ(nodes["talker"], (GraphNode{"/uxv", "talker", {reader->gid}, {writer->gid}}));
  EXPECT_EQ(nodes["listener"], (GraphNode{"/uxv", "listener", {reader->gid}, {}}));
}

TEST(Graph, NodesAreWhatAPeerSinceIronDecodes) {
  expect_our_nodes<rmw_dds_common_msg_ParticipantEntitiesInfo>(
      rmw_dds_common_msg_ParticipantEntitiesInfo_desc, "typehash=RIHS01_91a0593b;");
}

TEST(Graph, NodesAreWhatAPeerOfHumbleDecodes) {
  expect_our_nodes<rmw_dds_common_humble_ParticipantEntitiesInfo>(
      rmw_dds_common_humble_ParticipantEntitiesInfo_desc, "");
}

TEST(Graph, AProcessIsAParticipantOfRos2AndItsEndsTellTheHashOfTheirType) {
  const int domain = next_domain();
  const CycloneParticipant cyclone(domain);
  const Process process(domain);
  const auto writer = [&] {
    return heard_end(cyclone, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, "rt/uxv/chatter");
  };
  ASSERT_TRUE(eventually([&] { return writer().has_value(); }));
  EXPECT_THAT(heard_participants(cyclone),
              ::testing::Contains(::testing::StartsWith("enclave=/;")));
  EXPECT_THAT(writer()->user_data,
              HasSubstr("typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f"
                        "6b1a18;"));
}

}  // namespace
}  // namespace tocsin::interop
