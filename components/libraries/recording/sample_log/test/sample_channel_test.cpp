// SPDX-License-Identifier: Apache-2.0
#include "sample_channel.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::sample_log {
namespace {

LoggedStream odom() {
  return {"odom|layout=1;",
          "/odom",
          {3, "nav_msgs/msg/Odometry", "ros2msg", "text"},
          {{"fact", "value"}}};
}

TEST(SampleChannel, ASampleIsKnownByItsChannelAndTheLowBitsOfItsNumber) {
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t sequence : {std::uint64_t{0}, std::uint64_t{7}, std::uint64_t{1} << 32U,
                                       (std::uint64_t{5} << 32U) + 9, largest}) {
    const SampleId id{1, largest, sequence};
    EXPECT_EQ(sample_id(channel_key(id), static_cast<std::uint32_t>(sequence)), id);
  }
}

TEST(SampleChannel, WritersAndEpochsHaveChannelsOfTheirOwn) {
  const ChannelKey one = channel_key({1, 2, 3});
  EXPECT_FALSE(one < channel_key({1, 2, 4}));
  EXPECT_FALSE(channel_key({1, 2, 4}) < one);
  EXPECT_TRUE(one < channel_key({1, 3, 3}));
  EXPECT_TRUE(one < channel_key({2, 2, 3}));
  EXPECT_TRUE(one < channel_key({1, 2, std::uint64_t{1} << 32U}));
}

TEST(SampleChannel, TellsEverythingThatALaterLifeNeeds) {
  const ChannelKey key{stream_key("odom|layout=1;"), 4711, 2};
  const mcap::Channel channel = to_channel(odom(), key, 3);
  EXPECT_EQ(channel.topic, "/odom");
  EXPECT_EQ(channel.message_encoding, "cdr");
  EXPECT_EQ(channel.schema_id, 3);
  const auto back = key_of(channel);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->stream, key.stream);
  EXPECT_EQ(back->source, 4711U);
  EXPECT_EQ(back->sequence_high, 2U);
  const LoggedStream stream = stream_of(channel, odom().schema);
  EXPECT_EQ(stream.name, odom().name);
  EXPECT_EQ(stream.topic, odom().topic);
  EXPECT_EQ(stream.facts, odom().facts);
  EXPECT_EQ(stream.schema.name, "nav_msgs/msg/Odometry");
}

TEST(SampleChannel, AChannelOfAnotherToolHasNoKey) {
  mcap::Channel foreign;
  foreign.topic = "/odom";
  EXPECT_FALSE(key_of(foreign));
  foreign = to_channel(odom(), {1, 2, 3}, 1);
  foreign.metadata["writer"] = "twelve";
  EXPECT_FALSE(key_of(foreign));
  foreign.metadata["writer"] = "12x";
  EXPECT_FALSE(key_of(foreign));
  foreign.metadata.erase("writer");
  EXPECT_FALSE(key_of(foreign));
}

}  // namespace
}  // namespace tocsin::sample_log
