// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/ros_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace type = rcl_interfaces::msg::ParameterType_Constants;

const std::vector<ParameterFacts> facts{
    {"speed_mps", 0.5, "[m/s] fast", Range{0, 1}, {}, true},
    {"pictures", std::int64_t{8}, "[1/s] rate", Range{1, std::numeric_limits<double>::infinity()}},
    {"policy", std::string("none"), "that decides", std::nullopt, {"none", "tocp"}},
    {"camera.width", std::int64_t{640}, "[px]"},
    {"camera.lens.focus", 1.0, "[m]"}};

TEST(RosParameters, AValueHasTheTypeThatRos2HasForIt) {
  EXPECT_EQ(ros_value(true).type(), type::PARAMETER_BOOL);
  EXPECT_TRUE(ros_value(true).bool_value());
  EXPECT_EQ(ros_value(std::int64_t{3}).integer_value(), 3);
  EXPECT_EQ(ros_value(0.5).double_value(), 0.5);
  EXPECT_EQ(ros_value(std::string("x")).string_value(), "x");
  EXPECT_EQ(ros_value(std::vector<double>{1, 2}).type(), type::PARAMETER_DOUBLE_ARRAY);
  EXPECT_EQ(ros_value(std::vector<std::string>{"a"}).type(), type::PARAMETER_STRING_ARRAY);
}

TEST(RosParameters, AValueGoesToYamlAndBack) {
  for (const ParameterValue& value : std::vector<ParameterValue>{
           true, std::int64_t{-7}, 0.25, std::string("a: b"), std::vector<double>{0.5, 1.5},
           std::vector<std::string>{"x", "y z"}}) {
    const auto yaml = yaml_of(ros_value(value));
    ASSERT_TRUE(yaml);
    const std::string text = YAML::Dump(*yaml);
    const YAML::Node read = YAML::Load(text);
    if (const auto* number = std::get_if<double>(&value)) {
      EXPECT_EQ(read.as<double>(), *number);
    }
    if (const auto* words = std::get_if<std::string>(&value)) {
      EXPECT_EQ(read.as<std::string>(), *words);
    }
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
      EXPECT_EQ(read.as<std::vector<double>>(), *list);
    }
  }
  EXPECT_FALSE(yaml_of(RosValue()));
}

TEST(RosParameters, AWholeNumberMayBeGivenForANumberAndNothingElseForAnother) {
  EXPECT_EQ(type_fault(0.5, ros_value(std::int64_t{1})), "");
  EXPECT_EQ(type_fault(std::vector<double>{}, ros_value(std::vector<double>{1})), "");
  EXPECT_EQ(type_fault(std::int64_t{1}, ros_value(0.5)), "is of type integer, not double");
  EXPECT_EQ(type_fault(true, ros_value(std::string("true"))), "is of type boolean, not string");
  EXPECT_EQ(type_fault(0.5, RosValue()), "is of type double, not not set");
}

TEST(RosParameters, ADescriptionTellsRangeChoicesAndWhetherItIsLive) {
  const auto speed = describe(facts[0]);
  EXPECT_EQ(speed.name(), "speed_mps");
  EXPECT_EQ(speed.type(), type::PARAMETER_DOUBLE);
  EXPECT_EQ(speed.description(), "[m/s] fast");
  EXPECT_FALSE(speed.read_only());
  ASSERT_EQ(speed.floating_point_range().size(), 1U);
  EXPECT_EQ(speed.floating_point_range()[0].to_value(), 1);
  const auto pictures = describe(facts[1]);
  EXPECT_TRUE(pictures.read_only());
  ASSERT_EQ(pictures.integer_range().size(), 1U);
  EXPECT_EQ(pictures.integer_range()[0].from_value(), 1);
  EXPECT_GT(pictures.integer_range()[0].to_value(), 9'000'000'000'000'000'000);
  EXPECT_EQ(describe(facts[2]).additional_constraints(), "one of: none, tocp");
  EXPECT_THAT(describe(facts[2]).floating_point_range(), IsEmpty());
}

TEST(RosParameters, AListHasWhatIsBelowAPrefixUpToADepth) {
  rcl_interfaces::srv::ListParameters_Request request;
  EXPECT_EQ(list_parameters(facts, request).names().size(), 5U);
  EXPECT_THAT(list_parameters(facts, request).prefixes(), ElementsAre("camera", "camera.lens"));
  request.prefixes({"camera"});
  EXPECT_THAT(list_parameters(facts, request).names(),
              ElementsAre("camera.width", "camera.lens.focus"));
  request.depth(1);
  EXPECT_THAT(list_parameters(facts, request).names(), ElementsAre("camera.width"));
  request.prefixes({});
  EXPECT_THAT(list_parameters(facts, request).names(),
              ElementsAre("speed_mps", "pictures", "policy"));
  request.prefixes({"policy", "nothing"});
  EXPECT_THAT(list_parameters(facts, request).names(), ElementsAre("policy"));
}

TEST(RosParameters, AValueIsTheSameWhereOnlyItsTypeDiffers) {
  const auto value = [](const char* text) { return ros_value_of(YAML::Load(text), "it"); };
  EXPECT_TRUE(has_value(ParameterValue(2.0), value("2")));
  EXPECT_TRUE(has_value(ParameterValue(std::nan("")), value(".nan")));
  EXPECT_FALSE(has_value(ParameterValue(2.0), value("2.5")));
  EXPECT_FALSE(has_value(ParameterValue(2.0), value("[2.0]")));
  EXPECT_FALSE(has_value(ParameterValue(std::int64_t{2}), value("2.0")));
  EXPECT_TRUE(has_value(ParameterValue(std::string("2")), value("'2'")));
  EXPECT_FALSE(has_value(ParameterValue(std::string("2")), value("2")));
  EXPECT_TRUE(has_value(ParameterValue(std::vector<double>{1, 2}), value("[1, 2]")));
  EXPECT_FALSE(has_value(ParameterValue(std::vector<double>{1, 2}), value("[1]")));
  EXPECT_FALSE(has_value(ParameterValue(std::vector<std::string>{"a"}), value("[b]")));
}

// A client cannot know of which type the elements are that a list has not.
TEST(RosParameters, AnEmptyListIsOfAnyType) {
  RosValue none;
  none.type(type::PARAMETER_BOOL_ARRAY);
  EXPECT_TRUE(has_value(ParameterValue(std::vector<std::string>()), none));
  EXPECT_TRUE(has_value(ParameterValue(std::vector<double>()), none));
  EXPECT_FALSE(has_value(ParameterValue(std::vector<double>{1}), none));
}

TEST(RosParameters, TypesHaveRos2sWords) {
  EXPECT_STREQ(type_word(type::PARAMETER_NOT_SET), "not set");
  EXPECT_STREQ(type_word(type::PARAMETER_BOOL), "boolean");
  EXPECT_STREQ(type_word(type::PARAMETER_STRING_ARRAY), "string array");
  EXPECT_STREQ(type_word(200), "unknown");
}

}  // namespace
}  // namespace tocsin
