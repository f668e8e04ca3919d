// SPDX-License-Identifier: Apache-2.0
#include "router_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tocsin {
namespace {

std::optional<StreamPath> same(std::uint32_t id) { return StreamPath{id, 0}; }

router::LinkAcknowledgement acknowledgement() {
  router::LinkAcknowledgement acknowledgement;
  acknowledgement.count = 3;
  acknowledgement.made = Time(std::chrono::seconds(5));
  acknowledgement.streams = {{7, 100, std::chrono::microseconds(2500), 0b101},
                             {9, 4, std::chrono::seconds(60), 0}};
  return acknowledgement;
}

TEST(RouterMessages, AnAcknowledgementIsReadAsItWasWritten) {
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
    return id == 9 ? std::optional(StreamPath{90, 1}) : std::nullopt;
  };
  const auto back = to_acknowledgement(to_message(acknowledgement()), only_nine);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->streams.size(), 1U);
  EXPECT_EQ(back->streams[0].stream, 90U);
  EXPECT_EQ(back->streams[0].path, 1);
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

}  // namespace
}  // namespace tocsin
