// SPDX-License-Identifier: Apache-2.0
// Random messages of all types of ROS that are restated here: printed and read back they are the
// same, byte for byte.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "foundation/ros_names.hpp"
#include "idl_support/encode.hpp"
#include "idl_support/type_registry.hpp"
#include "message_yaml.hpp"
#include "ros_idl/nav_msgs.hpp"

namespace tocsin::topic_tool {
namespace {

std::uint64_t seed() {
  const char* const given = std::getenv("TOCSIN_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

/// Gives every field a random value.
class Shaker final : public FieldEditor {
 public:
  explicit Shaker(std::mt19937_64& random) : random_(random) {}
  void number(const char*, double& value) override {
    static const std::vector<double> odd{0, -0.5, 1e20, 1e-7, 0.1, -INFINITY, INFINITY};
    value =
        below(3) == 0 ? odd[below(odd.size())] : static_cast<float>(below(2'000'000)) / 1000 - 1000;
  }
  void integer(const char*, std::int64_t& value, const IntegerRange& range) override {
    const std::vector<std::int64_t> some{range.least, range.most, 0, 1};
    value = some[below(some.size())];
  }
  void boolean(const char*, bool& value) override { value = below(2) == 1; }
  void text(const char*, std::string& value) override {
    static const std::vector<std::string> odd{"",       "true", "1.5",  "a: b",    "it's",
                                              "- x",    "#",    "null", "~",       "[1]",
                                              "{a: 1}", " a ",  "0x10", "\xc3\xa9"};
    value = odd[below(odd.size())];
  }
  void bytes(const char*, std::vector<std::uint8_t>& value) override {
    value.resize(below(4));
    for (std::uint8_t& byte : value) byte = static_cast<std::uint8_t>(below(256));
  }
  void begin_struct(const char*) override {}
  void end_struct() override {}
  std::size_t begin_list(const char*, std::size_t size) override {
    return size == 0 ? below(3) : size;
  }
  void end_list() override {}

 private:
  [[nodiscard]] std::size_t below(std::size_t limit) { return random_() % limit; }
  std::mt19937_64& random_;
};

class RandomMessage : public ::testing::TestWithParam<const char*> {};

TEST_P(RandomMessage, IsTheSameAfterPrintingAndReading) {
  (void)type_info<nav_msgs::msg::Odometry>();  // its library is linked, and so all are registered
  const TypeInfo* const type = find_type(wire_type(GetParam()));
  ASSERT_NE(type, nullptr);
  const std::uint64_t first = seed();
  std::mt19937_64 random(first);
  EchoOptions whole;
  whole.longest = 0;
  for (int round = 0; round < 50; ++round) {
    const auto message = type->create();
    Shaker shaker(random);
    type->edit(message.get(), shaker);
    const std::string text = to_yaml(*type, message.get(), whole);
    const auto again = from_yaml(*type, text);
    ASSERT_EQ(encode(*type, again.get()), encode(*type, message.get()))
        << "TOCSIN_TEST_SEED=" << first << " round " << round << "\n"
        << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Types, RandomMessage,
                         ::testing::Values("std_msgs/msg/String", "std_msgs/msg/Header",
                                           "geometry_msgs/msg/PoseWithCovarianceStamped",
                                           "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry",
                                           "nav_msgs/msg/Path", "sensor_msgs/msg/BatteryState",
                                           "sensor_msgs/msg/Imu", "sensor_msgs/msg/CompressedImage",
                                           "sensor_msgs/msg/JointState",
                                           "diagnostic_msgs/msg/DiagnosticArray",
                                           "tf2_msgs/msg/TFMessage"));

}  // namespace
}  // namespace tocsin::topic_tool
