// SPDX-License-Identifier: Apache-2.0
#include "action_text.hpp"

#include <gtest/gtest.h>

namespace tocsin::topic_tool {
namespace {

Gid gid(std::uint8_t last) {
  Gid made{};
  made.back() = last;
  return made;
}

GraphEnd end(const char* topic, const char* type, std::uint8_t its_gid, bool writer) {
  GraphEnd made;
  made.topic = topic;
  made.type = type;
  made.gid = gid(its_gid);
  made.writer = writer;
  return made;
}

constexpr const char* feedback = "rt/uxv/dock/_action/feedback";
constexpr const char* feedback_type =
    "kobuki_ros_interfaces::action::dds_::AutoDocking_FeedbackMessage_";
const std::vector<GraphEnd> ends{
    end(feedback, feedback_type, 1, true), end(feedback, feedback_type, 2, false),
    end("rt/uxv/dock/_action/status", "action_msgs::msg::dds_::GoalStatusArray_", 3, true),
    end("rt/odom", "nav_msgs::msg::dds_::Odometry_", 4, true),
    end("rt/nobody/_action/feedback", "nav2_msgs::action::dds_::NavigateToPose_FeedbackMessage_", 5,
        true)};
const std::vector<GraphNode> nodes{{"/uxv", "auto_docking", {}, {gid(1), gid(3)}},
                                   {"/uxv", "operator", {gid(2)}, {}}};

TEST(ActionText, ListsActionsByTheirFeedback) {
  const auto sut = actions_in(ends, nodes);
  EXPECT_EQ(action_list_text(sut, {}), "/nobody\n/uxv/dock\n");
  EXPECT_EQ(action_list_text(sut, {true, false}),
            "/nobody [nav2_msgs/action/NavigateToPose]\n"
            "/uxv/dock [kobuki_ros_interfaces/action/AutoDocking]\n");
  EXPECT_EQ(action_list_text(sut, {false, true}), "2\n");
}

TEST(ActionText, InfoSaysWhoServesAndWhoCalls) {
  const auto sut = actions_in(ends, nodes).at("/uxv/dock");
  EXPECT_EQ(action_info_text("/uxv/dock", sut, {}),
            "Action: /uxv/dock\n"
            "Action clients: 1\n"
            "    /uxv/operator\n"
            "Action servers: 1\n"
            "    /uxv/auto_docking\n");
  EXPECT_EQ(action_info_text("/uxv/dock", sut, {true, false}),
            "Action: /uxv/dock\n"
            "Action clients: 1\n"
            "    /uxv/operator [kobuki_ros_interfaces/action/AutoDocking]\n"
            "Action servers: 1\n"
            "    /uxv/auto_docking [kobuki_ros_interfaces/action/AutoDocking]\n");
  EXPECT_EQ(action_info_text("/uxv/dock", sut, {false, true}),
            "Action: /uxv/dock\nAction clients: 1\nAction servers: 1\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
