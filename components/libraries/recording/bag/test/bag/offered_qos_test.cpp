// SPDX-License-Identifier: Apache-2.0
#include "bag/offered_qos.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::bag {
namespace {

/// As rosbag2 of Humble writes a reliable, volatile writer.
const std::string humble =
    "- history: 3\n  depth: 0\n  reliability: 1\n  durability: 2\n"
    "  deadline:\n    sec: 9223372036\n    nsec: 854775807\n"
    "  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n"
    "  liveliness: 1\n"
    "  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n"
    "  avoid_ros_namespace_conventions: false";

/// As rosbag2 of Jazzy writes a state.
const std::string jazzy =
    "- history: keep_last\n  depth: 1\n  reliability: reliable\n  durability: transient_local\n"
    "  deadline:\n    sec: 2\n    nsec: 500000000\n"
    "  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n"
    "  liveliness: manual_by_topic\n"
    "  liveliness_lease_duration:\n    sec: 1\n    nsec: 0\n"
    "  avoid_ros_namespace_conventions: false\n";

TEST(OfferedQos, IsWrittenAsAllReleasesReadIt) {
  EXPECT_EQ(to_yaml({OfferedQos{}}), humble);
  EXPECT_EQ(to_yaml(std::vector<OfferedQos>{}), "");
}

TEST(OfferedQos, CallsALongDurationInfinite) {
  EXPECT_EQ(finite_ns(0.5), 500'000'000);
  EXPECT_EQ(finite_ns(9e9), std::nullopt);
  EXPECT_EQ(finite_ns(HUGE_VAL), std::nullopt);
}

TEST(OfferedQos, IsReadWithNumbers) {
  const auto offered = parse_offered_qos(humble);
  ASSERT_EQ(offered.size(), 1U);
  EXPECT_EQ(offered[0].reliability, OfferedQos::Reliability::reliable);
  EXPECT_EQ(offered[0].durability, OfferedQos::Durability::volatile_kind);
  EXPECT_EQ(offered[0].deadline_ns, std::nullopt);
}

TEST(OfferedQos, IsReadWithWords) {
  const auto offered = parse_offered_qos(jazzy);
  ASSERT_EQ(offered.size(), 1U);
  EXPECT_EQ(offered[0].history, OfferedQos::History::keep_last);
  EXPECT_EQ(offered[0].depth, 1);
  EXPECT_EQ(offered[0].durability, OfferedQos::Durability::transient_local);
  EXPECT_EQ(offered[0].liveliness, OfferedQos::Liveliness::manual_by_topic);
  EXPECT_EQ(offered[0].deadline_ns, 2'500'000'000);
  EXPECT_EQ(offered[0].lifespan_ns, std::nullopt);
  EXPECT_EQ(offered[0].liveliness_lease_ns, 1'000'000'000);
}

TEST(OfferedQos, HasItsDefaultWhereATextSaysNothingSensible) {
  const auto offered = parse_offered_qos(
      "- reliability: 99\n  durability: sometimes\n  depth: -3\n  deadline: soon\n"
      "  lifespan: {sec: 1}\n  liveliness: [1]\n");
  ASSERT_EQ(offered.size(), 1U);
  EXPECT_EQ(to_yaml(offered), humble);
}

TEST(OfferedQos, TakesADurationOfNothingForInfinite) {
  const auto offered = parse_offered_qos("- deadline: {sec: 0, nsec: 0}\n");
  EXPECT_EQ(offered.at(0).deadline_ns, std::nullopt);
}

TEST(OfferedQos, OfWhatIsNoListOfMapsIsNothing) {
  for (const std::string text : {"", "7", "a: b", "- 7\n- text", "[[[", "- {a: &x [*x]}", "\xff"}) {
    EXPECT_TRUE(parse_offered_qos(text).empty()) << text;
  }
}

}  // namespace
}  // namespace tocsin::bag
