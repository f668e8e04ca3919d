// SPDX-License-Identifier: Apache-2.0
#include "graph/ros_graph.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

Gid gid(std::uint8_t last) { return {1, 15, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 0, last, 4}; }

ParticipantNodes talker() {
  return {gid(1), {{"/robot", "talker", {gid(2)}, {gid(3), gid(4)}}, {"/robot", "quiet"}}};
}

TEST(RosGraph, AGidReadsAsRos2WritesIt) {
  EXPECT_EQ(text_of(gid(0xAB)), "01.0f.02.03.04.05.06.07.08.09.0a.0b.00.00.ab.04");
}

// By the rules of CDR, OMG DDSI-RTPS 2.3 section 10.
TEST(RosGraph, ASampleHasTheBytesOfRos2) {
  const ParticipantNodes nodes{gid(1), {{"/", "a", {gid(2)}, {}}}};
  Bytes expected{0, 1, 0, 0};
  const auto append = [&](const Bytes& more) {
    expected.insert(expected.end(), more.begin(), more.end());
  };
  const auto append_gid = [&](const Gid& one) {
    expected.insert(expected.end(), one.begin(), one.end());
  };
  append_gid(gid(1));
  append({1, 0, 0, 0, 2, 0, 0, 0, '/', 0, 0, 0, 2, 0, 0, 0, 'a', 0, 0, 0, 1, 0, 0, 0});
  append_gid(gid(2));
  append({0, 0, 0, 0});
  EXPECT_EQ(encode(nodes, GidSize::bytes_16), expected);
}

TEST(RosGraph, TheBytesTellWhichSizeTheyHave) {
  for (const GidSize size : {GidSize::bytes_16, GidSize::bytes_24}) {
    const auto nodes = decode_nodes(encode(talker(), size));
    ASSERT_TRUE(nodes);
    EXPECT_EQ(nodes->participant, gid(1));
    EXPECT_EQ(nodes->nodes, talker().nodes);
    EXPECT_TRUE(decode_nodes(encode(ParticipantNodes{gid(9), {}}, size))->nodes.empty());
  }
  constexpr std::size_t gids = 4;
  EXPECT_EQ(encode(talker(), GidSize::bytes_24).size(),
            encode(talker(), GidSize::bytes_16).size() + 8 * gids);
}

TEST(RosGraph, OtherBytesAreNoNodes) {
  Bytes bytes = encode(talker(), GidSize::bytes_16);
  EXPECT_FALSE(decode_nodes({}));
  EXPECT_FALSE(decode_nodes({0, 1, 0, 0}));
  bytes.resize(bytes.size() - 5);
  EXPECT_FALSE(decode_nodes(bytes));
  bytes = encode(talker(), GidSize::bytes_16);
  bytes.resize(bytes.size() + 40, 7);
  EXPECT_FALSE(decode_nodes(bytes));
}

TEST(RosGraph, PeersWithoutATypeHashAreHumble) {
  EXPECT_EQ(gid_size_for({}), GidSize::bytes_16);
  EXPECT_EQ(gid_size_for({""}), GidSize::bytes_24);
  EXPECT_EQ(gid_size_for({"", "typehash=RIHS01_91;"}), GidSize::bytes_16);
  EXPECT_EQ(gid_size_for({discovery_user_data()}), GidSize::bytes_16);
  EXPECT_EQ(gid_size_for({discovery_user_data(), ""}), GidSize::bytes_24);
}

TEST(RosGraph, TheEnvironmentMaySayTheSize) {
  ASSERT_EQ(setenv("ROS_DISTRO", "humble", 1), 0);
  EXPECT_EQ(gid_size_of_environment(), GidSize::bytes_24);
  ASSERT_EQ(setenv("ROS_DISTRO", "jazzy", 1), 0);
  EXPECT_EQ(gid_size_of_environment(), GidSize::bytes_16);
  ASSERT_EQ(unsetenv("ROS_DISTRO"), 0);
  EXPECT_EQ(gid_size_of_environment(), std::nullopt);
}

TEST(LocalNodesTest, AnEndThatTwoPortsShareStaysUntilBothAreGone) {
  LocalNodes sut("robot");
  sut.add("talker", LocalNodes::End::writer, gid(3));
  sut.add("talker", LocalNodes::End::writer, gid(3));
  sut.add("talker", LocalNodes::End::reader, gid(2));
  sut.add("", LocalNodes::End::reader, gid(5));
  const GraphNode talker{"/robot", "talker", {gid(2)}, {gid(3)}};
  EXPECT_EQ(sut.all(), std::vector<GraphNode>{talker});
  sut.remove("talker", LocalNodes::End::writer, gid(3));
  EXPECT_EQ(sut.all(), std::vector<GraphNode>{talker});
  sut.remove("talker", LocalNodes::End::writer, gid(3));
  sut.remove("talker", LocalNodes::End::reader, gid(2));
  EXPECT_TRUE(sut.all().empty());
}

TEST(LocalNodesTest, NodesOfOthersAreShownWithoutEndsAndOnce) {
  LocalNodes sut("robot");
  const std::uint64_t before = sut.changes();
  sut.show({"talker", "arm", ""});
  EXPECT_EQ(sut.all(), (std::vector<GraphNode>{{"/robot", "arm"}, {"/robot", "talker"}}));
  const std::uint64_t shown = sut.changes();
  EXPECT_GT(shown, before);
  sut.show({"talker", "arm"});
  EXPECT_EQ(sut.changes(), shown) << "the same again";
  sut.add("arm", LocalNodes::End::reader, gid(2));
  EXPECT_EQ(sut.all(),
            (std::vector<GraphNode>{{"/robot", "arm", {gid(2)}, {}}, {"/robot", "talker"}}));
  sut.show({});
  EXPECT_EQ(sut.all(), (std::vector<GraphNode>{{"/robot", "arm", {gid(2)}, {}}}));
}

}  // namespace
}  // namespace tocsin
