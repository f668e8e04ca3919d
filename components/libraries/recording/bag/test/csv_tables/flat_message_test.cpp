// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/flat_message.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "ros_idl/sensor_msgs.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {
namespace {

template <class T>
std::map<std::string, std::string> columns(const T& message) {
  std::map<std::string, std::string> found;
  for (const FlatField& field : flatten(type_info<T>(), &message)) found[field.name] = field.value;
  return found;
}

TEST(FlatMessage, NamesNestedFieldsByPath) {
  sensor_msgs::msg::CompressedImage message;
  message.header().stamp().sec(12);
  message.header().frame_id("camera");
  message.data({1, 2, 3});
  const auto sut = columns(message);
  EXPECT_EQ(sut.at("header.stamp.sec"), "12");
  EXPECT_EQ(sut.at("header.frame_id"), "camera");
  EXPECT_EQ(sut.at("data.size"), "3");
}

TEST(FlatMessage, WritesNumbersShortestAndExactAndNanEmpty) {
  tocsin_msgs::msg::Goal message;
  for (const auto& [x, text] : {std::pair(0.1, "0.1"),
                                {-2.5e-8, "-2.5e-08"},
                                {1e308, "1e+308"},
                                {std::numeric_limits<double>::quiet_NaN(), ""}}) {
    message.x(x);
    EXPECT_EQ(columns(message).at("x"), text);
  }
  tocsin_msgs::msg::CpuLoad list;
  list.core_percent({1.5F, 2.0F});
  EXPECT_EQ(columns(list).at("core_percent"), "[1.5,2]");
}

TEST(FlatMessage, WritesOfAListOfMoreThan4096ElementsOnlyTheNumber) {
  tocsin_msgs::msg::CpuLoad message;
  message.core_percent(std::vector<float>(4096, 1));
  EXPECT_EQ(columns(message).at("core_percent").substr(0, 5), "[1,1,");
  message.core_percent(std::vector<float>(4097, 1));
  EXPECT_EQ(columns(message).at("core_percent"), "4097");
}

TEST(FlatMessage, WritesListsOfStructsAsJsonObjects) {
  tocsin_msgs::msg::TrafficReport message;
  message.topics().resize(2);
  message.topics()[0].topic("a\"b");
  message.topics()[0].sent(7);
  const std::string json = columns(message).at("topics");
  EXPECT_EQ(json.substr(0, 44), R"([{"topic":"a\"b","traffic_class":"","paused")");
  EXPECT_NE(json.find(R"("sent":7,)"), std::string::npos);
  EXPECT_NE(json.find("},{"), std::string::npos);
  EXPECT_EQ(json.back(), ']');
}

TEST(FlatMessage, HasTheSameColumnsWhenListsAreEmpty) {
  tocsin_msgs::msg::TrafficReport empty;
  tocsin_msgs::msg::TrafficReport full;
  full.topics().resize(3);
  EXPECT_EQ(columns(empty).size(), columns(full).size());
  EXPECT_EQ(columns(empty).at("topics"), "[]");
}

// What a peer sends must not reach the terminal of who looks at the file.
TEST(FlatMessage, WritesTextsPrintableAndShort) {
  tocsin_msgs::msg::TransmissionState message;
  message.reason("one\n\x1b[2Jtwo\xff");
  EXPECT_EQ(columns(message).at("reason"), "one\\n\\x1b[2Jtwo\\xff");
  message.reason(std::string(std::size_t{1} << 20U, 'a'));
  EXPECT_EQ(columns(message).at("reason"), std::string(4096, 'a') + "... (1048576 bytes)");
}

TEST(FlatMessage, WritesTextsInListsAsJsonThatReadsBackAsPrintable) {
  tocsin_msgs::msg::TrafficReport message;
  message.topics().resize(1);
  message.topics()[0].topic("\x1b\"\xff");
  EXPECT_EQ(columns(message).at("topics").substr(0, 29), R"([{"topic":"\\x1b\"\\xff","tra)");
}

}  // namespace
}  // namespace tocsin
