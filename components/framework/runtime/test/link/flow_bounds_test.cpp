// SPDX-License-Identifier: Apache-2.0
// What a FlowTable refuses, and how much it takes at most.
#include <gtest/gtest.h>

#include <set>

#include "link/flow_table.hpp"
#include "qos/config_file.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

class FlowBoundsTest : public ::testing::Test {
 protected:
  static FlowTable::Guid guid(int participant, int entity) {
    FlowTable::Guid guid;
    guid.guidPrefix.value[2] = static_cast<std::uint8_t>(participant >> 8);
    guid.guidPrefix.value[3] = static_cast<std::uint8_t>(participant);
    guid.entityId.value[0] = static_cast<std::uint8_t>(entity >> 8);
    guid.entityId.value[1] = static_cast<std::uint8_t>(entity);
    return guid;
  }
  static AnnouncedEnd writer(const std::string& topic) {
    AnnouncedEnd end;
    end.topic = "rt/" + topic;
    end.type = "Type";
    end.writer = true;
    return end;
  }
  /// The topics of the flows that have come since the last call.
  std::set<std::string> taken() {
    std::set<std::string> topics;
    while (const auto event = sut_.pop()) {
      if (const auto* flow = std::get_if<link_event::PeerFlow>(&*event)) {
        topics.insert(flow->what.topic);
      }
    }
    return topics;
  }
  std::size_t events() {
    std::size_t count = 0;
    while (sut_.pop()) ++count;
    return count;
  }

  const ConfigFile file_{
      "uxv: {low: {topics: ['*']}}\n"
      "gcs: {low: {topics: ['*'], services: ['*']}, stays: ['*cmd_vel*']}\n"};
  const TrafficRules open_{file_.path(), Role::uxv};
  const TrafficRules shipped_{std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml", Role::uxv,
                              VehicleChain::ours};
  const Time now_{};
  FlowTable sut_{"", shipped_, [] {}};
};

TEST_F(FlowBoundsTest, OfAPeerOnlyWhatTheRulesNameOfItIsTaken) {
  const auto before = refused_names().total();
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  int entity = 0;
  for (const char* const topic :
       {"goal", "cmd_vel", "cmd_vel/navigation", "odom", "location", "emergency_stop/request",
        "link_stop", "link_acknowledgement", "link_backfill", "link_services", "rosout"}) {
    sut_.on_link_end(guid(9, ++entity), writer(topic), true);
  }
  const std::set<std::string> expected{"goal", "link_acknowledgement", "link_backfill",
                                       "link_services"};
  EXPECT_EQ(taken(), expected);
  EXPECT_EQ(refused_names().total() - before, 7U);
  EXPECT_FALSE(sut_.flow_of(guid(9, 2)));
}

TEST_F(FlowBoundsTest, OfCallsOnlyThoseOfTheFile) {
  const CallClass named{Role::uxv, TrafficClass::high, 5};
  const CallClass other{Role::uxv, TrafficClass::low, 5};
  sut_.on_link_end(guid(9, 1), writer(link_calls_topic(named)), true);
  sut_.on_link_end(guid(9, 2), writer(link_calls_topic(other)), true);
  sut_.on_link_end(guid(9, 3), writer(link_results_topic(named)), true);
  const std::set<std::string> expected{link_calls_topic(named), link_results_topic(named)};
  EXPECT_EQ(taken(), expected);
}

TEST_F(FlowBoundsTest, TheChainOfThisHostIsNotSentEither) {
  sut_.on_host_end(guid(1, 1), writer("cmd_vel"), true);
  sut_.on_host_end(guid(1, 2), writer("emergency_stop/request"), true);
  EXPECT_EQ(events(), 0U);
}

TEST_F(FlowBoundsTest, AThousandAnnouncementsOfAStrangerMakeNothing) {
  sut_.on_peer(guid(9, 0).guidPrefix, "stranger", true, now_);
  (void)events();
  for (int i = 1; i <= 1500; ++i) {
    sut_.on_link_end(guid(9, i), writer("t" + std::to_string(i)), true);
  }
  EXPECT_EQ(events(), 0U);
  EXPECT_LE(refused_names().lines().size(), RefusedNames::most_lines + 1);
}

TEST_F(FlowBoundsTest, OfAHostAndOfAPeerNoMoreThanAThousandFlowsAreTaken) {
  FlowTable sut("", open_, [] {});
  constexpr int most = FlowTable::most_flows;
  for (int i = 1; i <= most + 100; ++i) {
    sut.on_host_end(guid(1, i), writer("t" + std::to_string(i)), true);
    sut.on_link_end(guid(9, i), writer("t" + std::to_string(i)), true);
  }
  EXPECT_TRUE(sut.flow_of(guid(1, most)));
  EXPECT_FALSE(sut.flow_of(guid(1, most + 1)));
  EXPECT_TRUE(sut.flow_of(guid(9, most)));
  EXPECT_FALSE(sut.flow_of(guid(9, most + 1)));
  sut.on_host_end(guid(1, 7), writer("t7"), false);
  sut.on_host_end(guid(1, most + 1), writer("late"), true);
  EXPECT_TRUE(sut.flow_of(guid(1, most + 1)));  // there is room again
}

TEST_F(FlowBoundsTest, StrangersDoNotTakeTheRoomOfAPeerForever) {
  FlowTable sut("", open_, [] {});
  for (int peer = 1; peer <= 10; ++peer) {
    sut.on_peer(guid(peer, 0).guidPrefix, "s" + std::to_string(peer), true, now_);
    for (int i = 1; i <= 1000; ++i) sut.on_link_end(guid(peer, i), writer("t"), true);
  }
  EXPECT_FALSE(sut.flow_of(guid(10, 1000)));  // all together have no more than four thousand
  for (int peer = 1; peer <= 9; ++peer) sut.on_peer(guid(peer, 0).guidPrefix, "", false, now_);
  sut.on_link_end(guid(10, 1000), writer("t"), true);
  EXPECT_TRUE(sut.flow_of(guid(10, 1000)));
}

}  // namespace
}  // namespace tocsin
