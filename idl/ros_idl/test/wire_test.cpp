// SPDX-License-Identifier: Apache-2.0
// Bytes on the wire, written out by hand from the CDR rules (OMG DDSI-RTPS 2.3 section 10):
// 4-byte encapsulation 00 01 00 00, then each primitive aligned to its size from there.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "idl_support/type_registry.hpp"
#include "ros_idl/diagnostic_msgs.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

template <class T>
std::vector<std::uint8_t> encode(const T& message) {
  const TypeInfo& info = type_info<T>();
  std::vector<std::uint8_t> bytes(info.serialized_size(&message));
  EXPECT_EQ(info.serialize(&message, bytes.data(), bytes.size()), bytes.size());
  return bytes;
}

TEST(GeneratedTypes, ADefaultMessageIsZero) {
  // In memory that held something else before.
  alignas(nav_msgs::msg::Odometry) std::array<unsigned char, sizeof(nav_msgs::msg::Odometry)> room;
  room.fill(0xA5);
  auto* const sut = new (room.data()) nav_msgs::msg::Odometry;
  EXPECT_EQ(sut->header().stamp().sec(), 0);
  EXPECT_EQ(sut->child_frame_id(), "");
  EXPECT_EQ(sut->pose().pose().orientation().z(), 0);
  for (const double value : sut->twist().covariance()) EXPECT_EQ(value, 0);
  sut->~Odometry();
}

TEST(GeneratedTypes, CopiesAreEqualAndIndependentAndMovesLeaveNothingBehind) {
  using Odometry = nav_msgs::msg::Odometry;
  static_assert(std::is_nothrow_move_constructible_v<Odometry>);
  static_assert(std::is_nothrow_move_assignable_v<Odometry>);
  Odometry sut;
  sut.child_frame_id("a name that is longer than the small buffer of a string");
  sut.pose().covariance()[35] = 0.5;
  Odometry copy = sut;
  EXPECT_EQ(copy, sut);
  copy.pose().covariance()[35] = 1;
  EXPECT_EQ(sut.pose().covariance()[35], 0.5);
  const char* const text = sut.child_frame_id().data();
  const Odometry moved = std::move(sut);
  EXPECT_EQ(moved.child_frame_id().data(), text);
}

TEST(Wire, TypeNamesAreThoseOfRos2) {
  EXPECT_STREQ(type_info<nav_msgs::msg::Odometry>().name, "nav_msgs::msg::dds_::Odometry_");
  EXPECT_STREQ(type_info<std_msgs::msg::String>().name, "std_msgs::msg::dds_::String_");
}

TEST(Wire, StringIsLengthWithTerminatorAndBytes) {
  std_msgs::msg::String message;
  message.data("hi");
  const std::vector<std::uint8_t> expected{0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0};
  EXPECT_EQ(encode(message), expected);
}

TEST(Wire, HeaderIsStampThenFrame) {
  std_msgs::msg::Header message;
  message.stamp().sec(1);
  message.stamp().nanosec(2);
  message.frame_id("map");
  const std::vector<std::uint8_t> expected{0, 1, 0, 0, 1, 0, 0,   0,   2,   0,
                                           0, 0, 4, 0, 0, 0, 'm', 'a', 'p', 0};
  EXPECT_EQ(encode(message), expected);
}

TEST(Wire, TwistIsSixDoubles) {
  geometry_msgs::msg::Twist message;
  message.linear().x(1.0);
  const std::vector<std::uint8_t> bytes = encode(message);
  ASSERT_EQ(bytes.size(), 4U + 48U);
  double x = 0;
  std::memcpy(&x, bytes.data() + 4, sizeof x);
  EXPECT_EQ(x, 1.0);
}

TEST(Wire, OdometryDoublesAreAlignedAfterTheStrings) {
  nav_msgs::msg::Odometry message;
  message.header().frame_id("odom");      // 8 + 4 + 5 = 17 -> 20
  message.child_frame_id("base");         // 20 + 4 + 5 = 29 -> 32
  message.pose().pose().position().x(7);  // at 32 of the body
  const std::vector<std::uint8_t> bytes = encode(message);
  double x = 0;
  std::memcpy(&x, bytes.data() + 4 + 32, sizeof x);
  EXPECT_EQ(x, 7.0);
  EXPECT_EQ(bytes.size(), 4U + 32U + 8U * (7 + 36 + 6 + 36));
}

TEST(Wire, QuaternionDefaultsToIdentity) { EXPECT_EQ(geometry_msgs::msg::Quaternion().w(), 1.0); }

TEST(Wire, ALengthThatThePacketCannotHoldTakesNoMemory) {
  sensor_msgs::msg::CompressedImage sent;
  sent.data({1, 2, 3});
  std::vector<std::uint8_t> bytes = encode(sent);
  const std::uint32_t forged = 2'000'000'000;
  std::memcpy(&bytes[bytes.size() - 3 - sizeof forged], &forged, sizeof forged);
  sensor_msgs::msg::CompressedImage received;
  EXPECT_FALSE(type_info<sensor_msgs::msg::CompressedImage>().deserialize(bytes.data(),
                                                                          bytes.size(), &received));
  EXPECT_EQ(received.data().capacity(), 0U);
}

TEST(Wire, AForgedNumberOfStructsTakesNoMemory) {
  std::vector<std::uint8_t> bytes = encode(diagnostic_msgs::msg::DiagnosticArray());
  const std::uint32_t forged = 100'000'000;
  std::memcpy(&bytes[bytes.size() - sizeof forged], &forged, sizeof forged);
  diagnostic_msgs::msg::DiagnosticArray received;
  EXPECT_FALSE(type_info<diagnostic_msgs::msg::DiagnosticArray>().deserialize(
      bytes.data(), bytes.size(), &received));
  EXPECT_EQ(received.status().capacity(), 0U);
}

TEST(Wire, BigEndianLengthsAreRead) {
  const std::vector<std::uint8_t> bytes{0, 0, 0, 0, 0, 0, 0, 3, 'h', 'i', 0};
  std_msgs::msg::String received;
  ASSERT_TRUE(
      type_info<std_msgs::msg::String>().deserialize(bytes.data(), bytes.size(), &received));
  EXPECT_EQ(received.data(), "hi");
}

TEST(Wire, TypesAreFoundByName) {
  EXPECT_EQ(find_type("std_msgs::msg::dds_::Bool_"), &type_info<std_msgs::msg::Bool>());
  EXPECT_EQ(find_type("std_msgs::msg::dds_::Nothing_"), nullptr);
}

/// Writes "name=value " for leaves, to see the order.
class Lister : public FieldVisitor {
 public:
  void number(const char* name, double) override { text_ += std::string(name) + " "; }
  void integer(const char* name, std::int64_t) override { text_ += std::string(name) + " "; }
  void text(const char* name, const std::string& value) override {
    text_ += std::string(name) + "=" + value + " ";
  }
  void bytes(const char* name, const std::uint8_t*, std::size_t size) override {
    text_ += std::string(name) + "#" + std::to_string(size) + " ";
  }
  void begin_struct(const char* name) override { text_ += std::string(name) + "{ "; }
  void end_struct() override { text_ += "} "; }
  void begin_list(const char* name, std::size_t) override { text_ += std::string(name) + "[ "; }
  void end_list() override { text_ += "] "; }
  std::string text_;
};

TEST(Wire, VisitShowsFieldsInOrder) {
  sensor_msgs::msg::CompressedImage message;
  message.format("jpeg");
  message.data({1, 2, 3});
  Lister lister;
  type_info<sensor_msgs::msg::CompressedImage>().visit(&message, lister);
  EXPECT_EQ(lister.text_, "header{ stamp{ sec nanosec } frame_id= } format=jpeg data#3 ");
}

}  // namespace
}  // namespace tocsin
