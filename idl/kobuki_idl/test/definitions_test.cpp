// SPDX-License-Identifier: Apache-2.0
// The messages are those of kobuki_ros_interfaces (kobuki-base, branch devel), whose .msg files are
// restated here field by field: another field type is another type to ROS 2 and to who reads a bag.
#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "idl_support/type_definition.hpp"
#include "kobuki_idl/topics.hpp"

namespace tocsin {
namespace {

struct Published {
  std::string name;                 ///< of the .msg file
  std::vector<std::string> fields;  ///< without constants
};

const std::vector<Published> published{
    {"SensorState",
     {"std_msgs/Header header", "uint16 time_stamp", "uint8 bumper", "uint8 wheel_drop",
      "uint8 cliff", "uint16 left_encoder", "uint16 right_encoder", "int8 left_pwm",
      "int8 right_pwm", "uint8 buttons", "uint8 charger", "uint8 battery", "uint16[] bottom",
      "uint8[] current", "uint8 over_current", "uint16 digital_input", "uint16[] analog_input"}},
    {"DockInfraRed", {"std_msgs/Header header", "uint8[] data"}},
    {"ButtonEvent", {"uint8 button", "uint8 state"}},
    {"BumperEvent", {"uint8 bumper", "uint8 state"}},
    {"CliffEvent", {"uint8 sensor", "uint8 state", "uint16 bottom"}},
    {"WheelDropEvent", {"uint8 wheel", "uint8 state"}},
    {"PowerSystemEvent", {"uint8 event"}},
    {"DigitalInputEvent", {"bool[4] values"}},
    {"RobotStateEvent", {"uint8 state"}},
    {"VersionInfo",
     {"string hardware", "string firmware", "string software", "uint32[] udid", "uint64 features"}},
    {"ControllerInfo", {"uint8 type", "float64 p_gain", "float64 i_gain", "float64 d_gain"}},
    {"Led", {"uint8 value"}},
    {"Sound", {"uint8 value"}},
    {"DigitalOutput", {"bool[4] values", "bool[4] mask"}},
    {"ExternalPower", {"uint8 source", "uint8 state"}},
    {"MotorPower", {"uint8 state"}}};

/// The lines of a definition without their comments.
std::vector<std::string> fields_of(const TypeDefinition& definition) {
  std::vector<std::string> fields;
  std::istringstream lines(definition.text);
  for (std::string line; std::getline(lines, line);) {
    fields.push_back(line.substr(0, line.find("  #")));
  }
  return fields;
}

TEST(KobukiMessages, HaveTheFieldsOfTheirPackage) {
  for (const Published& one : published) {
    const auto ours = find_definition("kobuki_ros_interfaces::msg::dds_::" + one.name + "_");
    ASSERT_TRUE(ours) << one.name;
    EXPECT_EQ(fields_of(*ours), one.fields) << one.name;
  }
}

TEST(KobukiMessages, AreAllComparedWithTheirPackage) {
  std::size_t messages = 0;
  for (const std::string& name : known_definitions()) {
    messages += name.rfind("kobuki_ros_interfaces::msg::", 0) == 0;
  }
  EXPECT_EQ(messages, published.size());
}

/// As a reader of ROS 2 takes it: int8, of which -100 is a wheel that is driven backwards.
TEST(KobukiMessages, AWheelThatIsDrivenBackwardsHasANegativePwm) {
  topic::SensorsCore::Message message;
  message.left_pwm(std::int8_t{-100});
  message.right_pwm(std::int8_t{100});
  EXPECT_LT(message.left_pwm(), 0) << "on every processor, also where char has no sign";
  const TypeInfo& type = type_info<topic::SensorsCore::Message>();
  std::vector<std::uint8_t> bytes(type.serialized_size(&message));
  ASSERT_EQ(type.serialize(&message, bytes.data(), bytes.size()), bytes.size());
  // header 8 + 4 + 1, padding 1, time stamp 2, three bytes, padding 1, two encoders of 2
  const std::size_t at = 4 + 8 + 5 + 1 + 2 + 3 + 1 + 4;
  EXPECT_EQ(bytes.at(at), 0x9C);
  EXPECT_EQ(bytes.at(at + 1), 100);
}

}  // namespace
}  // namespace tocsin
