// SPDX-License-Identifier: Apache-2.0
#include "operator_server/message_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "idl_support/encode.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Joints = sensor_msgs::msg::JointState;
using Image = sensor_msgs::msg::CompressedImage;
using Pose = geometry_msgs::msg::PoseWithCovarianceStamped;

template <class Message>
Message made(const std::string& text) {
  const MadeMessage made = message_from_json(type_info<Message>(), text);
  EXPECT_EQ(made.fault, "");
  return made.message ? *std::static_pointer_cast<Message>(made.message) : Message();
}

TEST(MessageJsonTest, FillsNestedFieldsListsAndBytes) {
  const auto pose = made<Pose>(
      R"({"header": {"frame_id": "map", "stamp": {"sec": 5}}, "pose": {"pose": {"position": {"x": 1.5}}}})");
  EXPECT_EQ(pose.header().frame_id(), "map");
  EXPECT_EQ(pose.header().stamp().sec(), 5);
  EXPECT_EQ(pose.pose().pose().position().x(), 1.5);
  const auto joints = made<Joints>(R"({"name": ["a", "b"], "position": [1, null]})");
  EXPECT_EQ(joints.name().size(), 2U);
  EXPECT_TRUE(std::isnan(joints.position().at(1)));
  EXPECT_EQ(made<Image>(R"({"data": [1, 255]})").data().at(1), 255);
}

TEST(MessageJsonTest, EachBadValueIsNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"[]", "not a JSON object"},
      {"{", "not a JSON object"},
      {R"({"header": 1})", "header: must be an object"},
      {R"({"header": {"fram_id": "map"}})", "header: there is no field 'fram_id'; did you mean"},
      {R"({"header": {"stamp": {"sec": 2147483648}}})",
       "header.stamp.sec: must be a whole number in [-2147483648, 2147483647]"},
      {R"({"header": {"stamp": {"sec": 18446744073709551615}}})", "header.stamp.sec: must be"},
      {R"({"header": {"stamp": {"nanosec": -1}}})", "header.stamp.nanosec: must be"},
      {R"({"header": {"frame_id": 1}})", "header.frame_id: must be a text"},
      {R"({"pose": {"pose": {"position": {"x": "1"}}}})", "pose.pose.position.x: must be a number"},
      {R"({"pose": {"covariance": {}}})", "pose.covariance: must be a list"},
      {R"({"pose": {"covariance": [1, true]}})", "pose.covariance[1]: must be a number"},
  };
  for (const auto& [text, fault] : cases) {
    const MadeMessage made = message_from_json(type_info<Pose>(), text);
    EXPECT_EQ(made.message, nullptr) << text;
    EXPECT_THAT(made.fault, HasSubstr(fault)) << text;
  }
  EXPECT_THAT(message_from_json(type_info<Image>(), R"({"data": [256]})").fault,
              HasSubstr("data[0]: must be a whole number in [0, 255]"));
}

TEST(MessageJsonTest, AMessageThatIsWrittenReadsBackTheSame) {
  Joints joints;
  joints.header().frame_id("base");
  joints.name({"a", "b"});
  joints.position({1.25, -3e10});
  const json text = json_of(type_info<Joints>(), &joints);
  EXPECT_EQ(made<Joints>(text.dump()), joints);
}

TEST(MessageJsonTest, CdrIsCheckedBeforeItIsTaken) {
  std_msgs::msg::String text;
  text.data("hello");
  const auto& type = type_info<std_msgs::msg::String>();
  const auto bytes = encode(type, &text);
  const std::string payload(bytes.begin(), bytes.end());
  EXPECT_NE(message_from(type, "cdr", payload).message, nullptr);
  EXPECT_THAT(message_from(type, "cdr", payload.substr(0, 9)).fault, HasSubstr("9 bytes are not"));
  EXPECT_EQ(message_from(type, "cdr", "").message, nullptr);
}

}  // namespace
}  // namespace tocsin::foxglove
