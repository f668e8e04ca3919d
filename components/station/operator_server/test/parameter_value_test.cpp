// SPDX-License-Identifier: Apache-2.0
#include "operator_server/parameter_value.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::foxglove {
namespace {

using nlohmann::json;
namespace ros = rcl_interfaces::msg::ParameterType_Constants;

std::uint8_t type_of(const json& value, const std::string& type = "", std::uint8_t known = 0) {
  const auto given = given_value({"/a.b", value, type}, known);
  return given ? given->type() : std::uint8_t{255};
}

TEST(ParameterValueTest, SplitsNamesIntoNodeAndParameter) {
  const auto name = split_parameter_name("/navigator.limits.speed_mps");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->node, "navigator");
  EXPECT_EQ(name->parameter, "limits.speed_mps");
  EXPECT_EQ(joined_parameter_name(*name), "/navigator.limits.speed_mps");
  for (const char* bad : {"", "navigator", "/navigator.", "/.speed", ".", "/"}) {
    EXPECT_FALSE(split_parameter_name(bad)) << bad;
  }
}

TEST(ParameterValueTest, GuessesTheTypeThatJsonDoesNotTell) {
  EXPECT_EQ(type_of(true), ros::PARAMETER_BOOL);
  EXPECT_EQ(type_of(1), ros::PARAMETER_INTEGER);
  EXPECT_EQ(type_of(1, "float64"), ros::PARAMETER_DOUBLE);
  EXPECT_EQ(type_of(1, "", ros::PARAMETER_DOUBLE), ros::PARAMETER_DOUBLE);
  EXPECT_EQ(type_of(1.5), ros::PARAMETER_DOUBLE);
  EXPECT_EQ(type_of("x"), ros::PARAMETER_STRING);
  EXPECT_EQ(type_of({"x", "y"}), ros::PARAMETER_STRING_ARRAY);
  EXPECT_EQ(type_of({1, 2}), ros::PARAMETER_INTEGER_ARRAY);
  EXPECT_EQ(type_of({1, 2}, "float64_array"), ros::PARAMETER_DOUBLE_ARRAY);
  EXPECT_EQ(type_of({1, 2.5}), ros::PARAMETER_DOUBLE_ARRAY);
  EXPECT_EQ(type_of({true, false}), ros::PARAMETER_BOOL_ARRAY);
  EXPECT_EQ(type_of(json::array(), "", ros::PARAMETER_STRING_ARRAY), ros::PARAMETER_STRING_ARRAY);
  EXPECT_EQ(type_of(nullptr), 255);
  EXPECT_EQ(type_of({1, "x"}), 255);
  EXPECT_EQ(type_of(json::object()), 255);
}

TEST(ParameterValueTest, WhatIsShownIsTakenBack) {
  for (const json& value :
       {json(true), json(3), json(2.0), json("x"), json({1.0, 2.0}), json({"a"}), json({1, 2})}) {
    const auto given = given_value({"/a.b", value, value.is_number_float() ? "float64" : ""}, 0);
    ASSERT_TRUE(given);
    const Parameter shown = shown_parameter("/a.b", *given);
    EXPECT_EQ(shown.value, value);
    EXPECT_EQ(given_value(shown, 0)->type(), given->type());
  }
}

TEST(ParameterValueTest, WhatJsonCannotSayIsNull) {
  rcl_interfaces::msg::ParameterValue value;
  EXPECT_TRUE(shown_parameter("/a.b", value).value.is_null());
  value.type(ros::PARAMETER_DOUBLE);
  value.double_value(std::numeric_limits<double>::infinity());
  EXPECT_TRUE(shown_parameter("/a.b", value).value.is_null());
}

}  // namespace
}  // namespace tocsin::foxglove
