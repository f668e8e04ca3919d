// SPDX-License-Identifier: Apache-2.0
#include "node_text.hpp"

#include <gtest/gtest.h>

namespace tocsin::topic_tool {
namespace {

Gid gid(std::uint8_t last) { return {1, 15, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, last, 3}; }

GraphEnd end(std::uint8_t id, const std::string& topic, const std::string& type, bool writer) {
  GraphEnd made;
  made.gid = gid(id);
  made.topic = topic;
  made.type = type;
  made.writer = writer;
  return made;
}

const std::vector<GraphEnd> ends{
    end(1, "rt/robot/chatter", "std_msgs::msg::dds_::String_", true),
    end(2, "rt/alarm", "std_msgs::msg::dds_::Bool_", false),
    end(3, "rq/robot/talker/get_parametersRequest",
        "rcl_interfaces::srv::dds_::GetParameters_Request_", false),
    end(4, "rr/robot/talker/get_parametersReply",
        "rcl_interfaces::srv::dds_::GetParameters_Response_", true),
    end(5, "rr/spinReply", "std_srvs::srv::dds_::Trigger_Response_", false),
    end(6, "rt/other", "std_msgs::msg::dds_::Bool_", true),
    end(7, "rq/dock/_action/send_goalRequest", "dock_msgs::action::dds_::Dock_SendGoal_Request_",
        false)};
const std::vector<GraphNode> nodes{
    {"/robot", "talker", {gid(2), gid(3), gid(5), gid(7)}, {gid(1), gid(4)}},
    {"/", "_ros2cli", {}, {gid(6)}},
    {"/", "bare"}};

TEST(NodeList, ShowsBothOfTwoWithOneName) {
  std::vector<GraphNode> twins = nodes;
  EXPECT_FALSE(has_twins(twins));
  twins.push_back({"/", "bare"});
  EXPECT_TRUE(has_twins(twins));
  EXPECT_EQ(node_list_text(twins, {}), "/bare\n/bare\n/robot/talker\n");
}

// Line by line what `ros2 node info` prints; an empty section is an empty line.
TEST(NodeInfo, IsWhatRos2Prints) {
  EXPECT_EQ(node_info_text(ends, nodes, "/robot/talker", false),
            "/robot/talker\n"
            "  Subscribers:\n"
            "    /alarm: std_msgs/msg/Bool\n"
            "  Publishers:\n"
            "    /robot/chatter: std_msgs/msg/String\n"
            "  Service Servers:\n"
            "    /robot/talker/get_parameters: rcl_interfaces/srv/GetParameters\n"
            "  Service Clients:\n"
            "    /spin: std_srvs/srv/Trigger\n"
            "  Action Servers:\n"
            "    /dock: dock_msgs/action/Dock\n"
            "  Action Clients:\n"
            "\n");
}

TEST(NodeInfo, LeavesOutWhatIsNoTopicOfRosAndWhatOthersHave) {
  const GraphNode one{"/", "one", {gid(1), gid(2)}, {}};
  const std::string text = node_info_text(
      {end(1, "Square", "ShapeType", false), end(2, "rt/x", "a::msg::dds_::A_", true),
       end(9, "rt/y", "a::msg::dds_::A_", false)},
      {one}, "one", false);
  EXPECT_EQ(text,
            "/one\n  Subscribers:\n\n  Publishers:\n\n  Service Servers:\n\n"
            "  Service Clients:\n\n  Action Servers:\n\n  Action Clients:\n\n");
}

TEST(NodeInfo, ShowsNoControlCharactersOfOthers) {
  const GraphNode odd{"/", "odd", {gid(1)}, {}};
  const std::string text =
      node_info_text({end(1, "rt/\x1b[2J", "a::msg::dds_::A_", false)}, {odd}, "odd", false);
  EXPECT_NE(text.find("    /\\x1b[2J: a/msg/A\n"), std::string::npos) << text;
  EXPECT_EQ(node_list_text({{"/", "o\x1b"}}, {}), "/o\\x1b\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
