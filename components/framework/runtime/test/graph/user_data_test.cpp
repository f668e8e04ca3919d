// SPDX-License-Identifier: Apache-2.0
// What our ends announce, taken apart by the rule of ROS 2.
#include <gtest/gtest.h>

#include "fast_dds/remote_ends.hpp"
#include "graph/ros2_user_data.hpp"
#include "graph/ros_graph.hpp"
#include "link/flow_text.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

const std::string hash = "RIHS01_" + std::string(64, 'a');

TEST(Ros2UserData, OfOneKeyWithAnotherSignNothingIsLeft) {
  EXPECT_EQ(ros2_type_hash("typehash=" + hash + ";"), hash);
  EXPECT_EQ(ros2_type_hash("some_key=1;typehash=" + hash + ";"), "");
  EXPECT_EQ(ros2_type_hash("mine;typehash=" + hash + ";"), "");
  EXPECT_EQ(ros2_type_hash(std::string("typehash=") + hash + ";" + '\0'), hash);
}

TEST(UserDataForRos2, TheHashIsReadBesideTheLayoutInEitherOrder) {
  EXPECT_EQ(ros2_type_hash(with_type_hash(with_layout("", "0a"), hash)), hash);
  EXPECT_EQ(ros2_type_hash(with_layout(with_type_hash("", hash), "0a")), hash);
  EXPECT_EQ(ros2_user_data(with_layout("", "0a")).count("tocsinlayout"), 1U);
}

TEST(UserDataForRos2, TheHashIsReadBesideWhatTheStationsWritersAnnounce) {
  const std::string announced = joined(with_type_hash("", hash), topic::EmergencyStop::station);
  EXPECT_EQ(ros2_type_hash(announced), hash);
}

TEST(UserDataForRos2, TheHashIsReadBesideWhatARouterTellsOfAFlow) {
  Flow flow;
  flow.user_data = with_type_hash("", hash);
  EXPECT_EQ(ros2_type_hash(announcement_of(flow)), hash);
}

TEST(UserDataForRos2, WhoTellsNodesHasAHashAndAParticipantAnEnclave) {
  EXPECT_EQ(ros2_type_hash(discovery_user_data()).substr(0, 7), "RIHS01_");
  EXPECT_EQ(ros2_user_data(participant_user_data).at("enclave"), "/");
}

TEST(TypeHashInUserData, IsOneOnlyWithItsSixtyFourDigits) {
  EXPECT_EQ(type_hash_in("a=1;typehash=" + hash + ";b=2;"), hash);
  EXPECT_EQ(type_hash_in("typehash=" + hash), hash);
  EXPECT_EQ(type_hash_in("typehash=" + hash.substr(1) + ";"), "");
  EXPECT_EQ(type_hash_in("typehash=" + hash + "a;"), "");
  EXPECT_EQ(type_hash_in("typehash=RIHS01_" + std::string(64, 'g') + ";"), "");
  EXPECT_EQ(type_hash_in("a=1;"), "");
}

}  // namespace
}  // namespace tocsin
