// SPDX-License-Identifier: Apache-2.0
#include "router_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tocsin {
namespace {

std::optional<router::StreamId> same(std::uint32_t id) { return id; }

router::LinkAcknowledgement acknowledgement() {
  router::LinkAcknowledgement acknowledgement;
  acknowledgement.count = 3;
  acknowledgement.made = Time(std::chrono::seconds(5));
  acknowledgement.streams = {{7, 100, std::chrono::microseconds(2500), 0b101},
                             {9, 4, std::chrono::seconds(60), 0}};
  return acknowledgement;
}

TEST(RouterMessages, AAcknowledgementComesBackAsItWas) {
  const auto back = to_acknowledgement(to_message(acknowledgement()), same);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->count, 3U);
  EXPECT_EQ(back->made, Time(std::chrono::seconds(5)));
  ASSERT_EQ(back->streams.size(), 2U);
  EXPECT_EQ(back->streams[0].stream, 7U);
  EXPECT_EQ(back->streams[0].highest, 100U);
  EXPECT_EQ(back->streams[0].age, std::chrono::microseconds(2500));
  EXPECT_EQ(back->streams[0].before, 0b101U);
}

TEST(RouterMessages, AnAgeBeyondItsFieldIsTheOldestThatFits) {
  const auto back = to_acknowledgement(to_message(acknowledgement()), same);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->streams[1].age, 65535 * std::chrono::microseconds(100));
}

TEST(RouterMessages, AAcknowledgementOfFifteenStreamsIsSmall) {
  router::LinkAcknowledgement many;
  for (std::uint32_t i = 0; i < 15; ++i) many.streams.push_back({i, i, {}, i});
  const auto message = to_message(many);
  EXPECT_LE(type_info<tocsin_msgs::msg::LinkAcknowledgement>().serialized_size(&message), 350U);
}

TEST(RouterMessages, ListsOfUnequalLengthAreNoAcknowledgement) {
  for (int list = 0; list < 3; ++list) {
    auto message = to_message(acknowledgement());
    if (list == 0) message.highest().pop_back();
    if (list == 1) message.age_100us().push_back(1);
    if (list == 2) message.before().clear();
    EXPECT_FALSE(to_acknowledgement(message, same)) << list;
  }
}

TEST(RouterMessages, StreamsThatNobodyKnowsAreLeftOut) {
  const auto only_nine = [](std::uint32_t id) {
    return id == 9 ? std::optional<router::StreamId>(90) : std::nullopt;
  };
  const auto back = to_acknowledgement(to_message(acknowledgement()), only_nine);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->streams.size(), 1U);
  EXPECT_EQ(back->streams[0].stream, 90U);
}

TEST(RouterMessages, ARuleIsMadeOfWhatTheFileAndTheWritersSay) {
  Flow flow;
  flow.topic = "goal";
  flow.user_data = "station;";
  flow.transient_local = true;
  flow.depth = 4;
  flow.lifespan_s = 5;
  TrafficRule rule;
  rule.traffic_class = TrafficClass::high;
  rule.while_poor = WhilePoor::latest;
  rule.adaptive = true;
  const auto stream = stream_rule(flow, rule);
  EXPECT_EQ(stream.name, "goal|station;");
  EXPECT_EQ(stream.traffic_class, TrafficClass::high);
  EXPECT_EQ(stream.while_paused, router::WhilePaused::latest);
  EXPECT_EQ(stream.depth, 4U);
  EXPECT_EQ(stream.lifespan, seconds(5));
  EXPECT_TRUE(stream.repaired);
  EXPECT_TRUE(stream.durable);
  EXPECT_TRUE(stream.adaptive);
}

TEST(RouterMessages, AFlowWithoutLifespanLivesForEver) {
  EXPECT_EQ(stream_rule(Flow(), TrafficRule()).lifespan, Duration::max());
  EXPECT_FALSE(stream_rule(Flow(), TrafficRule()).repaired);
}

TEST(RouterMessages, AStateHasOneEntryForEachClassInTheirOrder) {
  router::LinkStateValues values;
  values.paused = true;
  values.loss = 0.25;
  values.classes[1].offered = 11;
  values.classes[1].dropped[static_cast<std::size_t>(router::DropReason::expired)] = 3;
  values.classes[1].delay = std::chrono::milliseconds(20);
  values.classes[1].unwanted = 2;
  values.capacity_measured = true;
  const auto message = to_message(values, {7, 700, 2, 200, {0, 300, 0, 100}});
  ASSERT_EQ(message.classes().size(), 4U);
  EXPECT_TRUE(message.capacity_measured());
  EXPECT_EQ(message.packets(), 7U);
  EXPECT_EQ(message.bytes(), 700U);
  EXPECT_EQ(message.discovery_bytes(), 200U);
  EXPECT_EQ(message.classes()[1].bytes(), 300U);
  EXPECT_EQ(message.classes()[3].bytes(), 100U);
  EXPECT_EQ(message.classes()[1].unwanted(), 2U);
  EXPECT_TRUE(message.paused());
  EXPECT_FLOAT_EQ(message.loss(), 0.25F);
  EXPECT_EQ(message.classes()[0].traffic_class(), "critical");
  EXPECT_EQ(message.classes()[3].traffic_class(), "low");
  EXPECT_EQ(message.classes()[1].offered(), 11U);
  EXPECT_EQ(message.classes()[1].dropped_expired(), 3U);
  EXPECT_FLOAT_EQ(message.classes()[1].delay_s(), 0.02F);
  EXPECT_TRUE(std::isnan(message.classes()[0].delay_s()));
}

}  // namespace
}  // namespace tocsin
