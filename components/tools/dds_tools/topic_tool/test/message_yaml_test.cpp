// SPDX-License-Identifier: Apache-2.0
#include "message_yaml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "foundation/error.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;

template <class Message>
std::string shown(const Message& message, const EchoOptions& options = {}) {
  return to_yaml(type_info<Message>(), &message, options);
}

template <class Message>
Message read(const std::string& text) {
  return *std::static_pointer_cast<Message>(from_yaml(type_info<Message>(), text));
}

template <class Message>
std::string refusal(const std::string& text) {
  try {
    (void)read<Message>(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std_msgs::msg::String text(const std::string& data) {
  std_msgs::msg::String message;
  message.data(data);
  return message;
}

TEST(ToYaml, IndentsStructsAndPrintsNumbersAsRos2Does) {
  geometry_msgs::msg::Twist twist;
  twist.linear().x(0.25);
  twist.angular().z(-2);
  EXPECT_EQ(shown(twist),
            "linear:\n  x: 0.25\n  y: 0.0\n  z: 0.0\nangular:\n  x: 0.0\n  y: 0.0\n  z: -2.0\n");
}

TEST(ToYaml, QuotesTextsThatYamlWouldReadAsSomethingElse) {
  EXPECT_EQ(shown(text("hello world")), "data: hello world\n");
  EXPECT_EQ(shown(text("")), "data: ''\n");
  EXPECT_EQ(shown(text("true")), "data: 'true'\n");
  EXPECT_EQ(shown(text("1.5")), "data: '1.5'\n");
  EXPECT_EQ(shown(text("it's")), "data: 'it''s'\n");
  EXPECT_EQ(shown(text("a: b")), "data: 'a: b'\n");
  EXPECT_EQ(shown(text("\x1b[31m")), "data: '\\x1b[31m'\n") << "a terminal is not told anything";
}

nav_msgs::msg::Path path_of(std::size_t poses) {
  nav_msgs::msg::Path path;
  path.header().frame_id("map");
  path.poses().resize(poses);
  for (std::size_t i = 0; i < poses; ++i)
    path.poses()[i].pose().position().x(static_cast<double>(i));
  return path;
}

TEST(ToYaml, PrintsAListOfStructsWithADashBeforeEach) {
  EXPECT_THAT(shown(path_of(2)), HasSubstr("\nposes:\n- header:\n    stamp:\n      sec: 0\n"));
  EXPECT_THAT(shown(path_of(2)), HasSubstr("\n  pose:\n    position:\n      x: 1.0\n"));
  EXPECT_THAT(shown(path_of(0)), HasSubstr("\nposes: []\n"));
}

TEST(ToYaml, ShowsOneField) {
  EchoOptions options;
  options.field = "header.frame_id";
  EXPECT_EQ(shown(path_of(1), options), "map\n");
  options.field = "header.stamp";
  EXPECT_EQ(shown(path_of(1), options), "sec: 0\nnanosec: 0\n");
  options.field = "poses";
  EXPECT_EQ(shown(path_of(0), options), "[]\n");
  options.field = "header.frame";
  EXPECT_THROW((void)shown(path_of(1), options), ConfigError);
}

TEST(ToYaml, WordsOfYamlAndNumbersAreQuotedWhateverTheirCase) {
  for (const char* plain : {"map", "a/b_c", "/uxv", "v1.2", "a b", "x+y-z"}) {
    EXPECT_EQ(shown(text(plain)), "data: " + std::string(plain) + "\n");
  }
  for (const char* odd : {"True", "NULL", "On", "7", "-1", "a  b", " a", "a ", "#a", "a,b", "é"}) {
    EXPECT_EQ(shown(text(odd)), "data: '" + std::string(odd) + "'\n");
  }
}

TEST(FromYaml, SetsWhatItNamesAndLeavesTheRest) {
  const auto twist = read<geometry_msgs::msg::Twist>("{linear: {x: 0.2}, angular: {z: -1}}");
  EXPECT_EQ(twist.linear().x(), 0.2);
  EXPECT_EQ(twist.linear().y(), 0);
  EXPECT_EQ(twist.angular().z(), -1);
  EXPECT_EQ(read<geometry_msgs::msg::Twist>(""), geometry_msgs::msg::Twist());
}

TEST(FromYaml, TakesWholeNumbersAndBooleansInTheirRange) {
  EXPECT_EQ(
      read<std_msgs::msg::Header>("{stamp: {sec: -5, nanosec: 4294967295}}").stamp().nanosec(),
      4294967295U);
  EXPECT_THAT(refusal<std_msgs::msg::Header>("{stamp: {nanosec: -1}}"),
              HasSubstr("stamp.nanosec: -1 is outside [0, 4294967295]"));
  EXPECT_THAT(refusal<std_msgs::msg::Header>("{stamp: {sec: 0.5}}"),
              HasSubstr("stamp.sec: '0.5' is not a whole number"));
  EXPECT_TRUE(read<std_msgs::msg::Bool>("{data: true}").data());
  EXPECT_THAT(refusal<std_msgs::msg::Bool>("{data: 3}"),
              HasSubstr("data: '3' is not true or false"));
  EXPECT_THAT(refusal<std_msgs::msg::Bool>("{data: [1]}"), HasSubstr("data: is not true or false"));
}

TEST(FromYaml, RefusesWhatIsNoYaml) {
  EXPECT_FALSE(refusal<std_msgs::msg::Bool>("{data: ").empty());
  EXPECT_FALSE(refusal<std_msgs::msg::Bool>("{data: true, data: false}").empty());
}

TEST(FromYaml, RefusesWhatIsNoFieldOrNoValueOfIt) {
  using Twist = geometry_msgs::msg::Twist;
  EXPECT_THAT(refusal<Twist>("{liner: {x: 1}}"), HasSubstr("no field 'liner'"));
  EXPECT_THAT(refusal<Twist>("{linear: {w: 1}}"), HasSubstr("linear: no field 'w'"));
  EXPECT_THAT(refusal<Twist>("{linear: {x: fast}}"), HasSubstr("linear.x: 'fast' is not a number"));
  EXPECT_THAT(refusal<Twist>("{linear: 3}"), HasSubstr("linear: must be a map"));
  EXPECT_THAT(refusal<Twist>("[1]"), HasSubstr("must be a map of fields"));
  EXPECT_THAT(refusal<nav_msgs::msg::Path>("{poses: 1}"), HasSubstr("poses: must be a list"));
  EXPECT_THAT(refusal<nav_msgs::msg::Path>("{poses: [{}, {pose: {position: {x: a}}}]}"),
              HasSubstr("poses[1].pose.position.x: 'a' is not a number"));
  EXPECT_THAT(refusal<sensor_msgs::msg::CompressedImage>("{data: [256]}"),
              HasSubstr("data[0]: 256 is outside [0, 255]"));
}

TEST(FromYaml, NamesTheFieldsThatThereAre) {
  const std::string refused = refusal<geometry_msgs::msg::Twist>("{linear: {xx: 1}}");
  EXPECT_THAT(refused, HasSubstr("linear: no field 'xx'"));
  for (const char* field : {"x", "y", "z"}) EXPECT_THAT(refused, HasSubstr(field));
}

TEST(FromYaml, RefusesMoreThanAPersonWrites) {
  const std::string deep = "{data: " + std::string(2000, '[') + std::string(2000, ']') + "}";
  EXPECT_FALSE(refusal<std_msgs::msg::Bool>(deep).empty());
  EXPECT_FALSE(refusal<std_msgs::msg::Bool>("&a {data: *a}").empty());
  EXPECT_EQ(read<std_msgs::msg::String>("{data: '[[[['}").data(), "[[[[") << "a text may hold them";
  EXPECT_EQ(read<std_msgs::msg::String>("{data: \"&a\"}").data(), "&a");
  EXPECT_EQ(read<std_msgs::msg::String>("# nothing").data(), "");
}

}  // namespace
}  // namespace tocsin::topic_tool
