// SPDX-License-Identifier: Apache-2.0
#include "param_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::ElementsAre;
namespace type = rcl_interfaces::msg::ParameterType_Constants;

TEST(ParamText, AValueIsShownAsRos2ShowsIt) {
  EXPECT_EQ(typed_value_text(ros_value(0.3)), "Double value is: 0.3");
  EXPECT_EQ(typed_value_text(ros_value(2.0)), "Double value is: 2.0");
  EXPECT_EQ(typed_value_text(ros_value(std::int64_t{8})), "Integer value is: 8");
  EXPECT_EQ(typed_value_text(ros_value(true)), "Boolean value is: True");
  EXPECT_EQ(typed_value_text(ros_value(std::string("a b"))), "String value is: a b");
  EXPECT_EQ(typed_value_text(ros_value(std::vector<std::string>{"a", "b"})),
            "String values are: ['a', 'b']");
  EXPECT_EQ(typed_value_text(ros_value(std::vector<double>{0.5, 1})),
            "Double values are: [0.5, 1.0]");
  EXPECT_EQ(typed_value_text(RosValue()), "Parameter not set.");
  EXPECT_EQ(value_text(ros_value(false)), "False");
}

TEST(ParamText, AValueHasTheTypeThatYamlGivesIt) {
  EXPECT_EQ(value_in("1").type(), type::PARAMETER_INTEGER);
  EXPECT_EQ(value_in("1.0").type(), type::PARAMETER_DOUBLE);
  EXPECT_EQ(value_in("true").type(), type::PARAMETER_BOOL);
  EXPECT_EQ(value_in("fast").string_value(), "fast");
  EXPECT_EQ(value_in("'1'").type(), type::PARAMETER_STRING);
  EXPECT_THAT(value_in("[1, 2]").integer_array_value(), ElementsAre(1, 2));
  EXPECT_THAT(value_in("[a, b]").string_array_value(), ElementsAre("a", "b"));
  EXPECT_THAT(value_in("[0.5]").double_array_value(), ElementsAre(0.5));
  EXPECT_EQ(value_in("[true]").type(), type::PARAMETER_BOOL_ARRAY);
  EXPECT_THROW((void)value_in("[1, a]"), ConfigError);
  EXPECT_THROW((void)value_in("{a: 1}"), ConfigError);
  EXPECT_THROW((void)value_in("[[1]]"), ConfigError);
}

TEST(ParamText, ADescriptionIsWhatRos2Prints) {
  rcl_interfaces::msg::ParameterDescriptor sut;
  sut.name("speed_mps");
  sut.type(type::PARAMETER_DOUBLE);
  sut.description("[m/s] fast");
  sut.read_only(true);
  sut.additional_constraints("one of: a, b");
  rcl_interfaces::msg::FloatingPointRange range;
  range.to_value(1.5);
  sut.floating_point_range({range});
  EXPECT_EQ(description_text(sut),
            "Parameter name: speed_mps\n  Type: double\n  Description: [m/s] fast\n"
            "  Constraints:\n    Read only: true\n    Min value: 0.0\n    Max value: 1.5\n"
            "    Additional constraints: one of: a, b\n");
}

TEST(ParamText, ADumpIsLoadedAsItWas) {
  const std::vector<NamedValue> values{
      {"speed_mps", ros_value(1.0)},
      {"count", ros_value(std::int64_t{3})},
      {"lit", ros_value(true)},
      {"name", ros_value(std::string("12"))},
      {"camera.topics", ros_value(std::vector<std::string>{"x", "y"})}};
  const std::string dumped = dump_text("/uxv/driver", values);
  EXPECT_EQ(dumped,
            "/uxv/driver:\n  ros__parameters:\n    speed_mps: 1.0\n    count: 3\n    lit: true\n"
            "    name: '12'\n    camera.topics: [x, y]\n");
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/driver.yaml";
  std::ofstream(file) << dumped;
  EXPECT_EQ(values_in_file(file, "/uxv/driver"), values);
}

TEST(ParamText, WholeNumbersHaveTheirRange) {
  rcl_interfaces::msg::ParameterDescriptor sut;
  sut.name("rate");
  sut.type(type::PARAMETER_INTEGER);
  rcl_interfaces::msg::IntegerRange range;
  range.from_value(1);
  range.to_value(30);
  sut.integer_range({range});
  EXPECT_EQ(description_text(sut),
            "Parameter name: rate\n  Type: integer\n  Constraints:\n    Min value: 1\n"
            "    Max value: 30\n");
}

TEST(ParamText, AFileMayNameAllNodesAndHaveMapsInMaps) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/all.yaml";
  std::ofstream(file) << "/**:\n  ros__parameters:\n    camera: {width: 640}\n"
                         "/other:\n  ros__parameters: {speed: 1}\n";
  const auto values = values_in_file(file, "/driver");
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].first, "camera.width");
  EXPECT_EQ(values[0].second.integer_value(), 640);
  std::ofstream(file) << "/other:\n  ros__parameters: {speed: 1}\n";
  EXPECT_THROW((void)values_in_file(file, "/driver"), ConfigError);
}

}  // namespace
}  // namespace tocsin::topic_tool
