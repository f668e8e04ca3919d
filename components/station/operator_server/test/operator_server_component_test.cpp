// SPDX-License-Identifier: Apache-2.0
#include "operator_server/operator_server_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idl_support/encode.hpp"
#include "served.hpp"

namespace tocsin {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;

json advertise_goal(const std::string& encoding) {
  return {{"op", "advertise"},
          {"channels",
           {{{"id", 5},
             {"topic", "/goal"},
             {"encoding", encoding},
             {"schemaName", "tocsin_msgs/msg/Goal"}}}}};
}

TEST(OperatorServerTest, AMessageReachesItsSubscribersAsTheBytesOfItsWriter) {
  Served sut;
  const auto client = sut.client();
  const auto other = sut.client();
  sut.subscribe(*client, "/goal", 7);
  tocsin_msgs::msg::Goal goal;
  goal.id(42);
  sut.bus.publish<topic::Goal>(goal);
  ASSERT_TRUE(sut.until([&] { return client->frames(1).size() == 1; }));
  const BinaryFrame frame = client->frames(1).front();
  EXPECT_EQ(frame.id, 7U);
  const auto wanted = encode(type_info<tocsin_msgs::msg::Goal>(), &goal);
  EXPECT_EQ(frame.bytes.substr(12), std::string(wanted.begin(), wanted.end()));
  sut.settle(*other);
  EXPECT_TRUE(other->frames(1).empty());
}

TEST(OperatorServerTest, AGoalOfAClientIsPublished) {
  for (const std::string encoding : {"json", "cdr"}) {
    Served sut;
    SimReader<topic::Goal> goals(sut.bus);
    const auto client = sut.client();
    client->say(advertise_goal(encoding));
    tocsin_msgs::msg::Goal goal;
    goal.id(42);
    const auto cdr = encode(type_info<tocsin_msgs::msg::Goal>(), &goal);
    const std::string payload =
        encoding == "json" ? R"({"id": 42})" : std::string(cdr.begin(), cdr.end());
    client->say_bytes("\x01" + bytes_of(5) + payload);
    std::vector<tocsin_msgs::msg::Goal> came;
    ASSERT_TRUE(sut.until([&] { return !(came = goals.take()).empty(); })) << encoding;
    EXPECT_EQ(came.front().id(), 42U);
  }
}

}  // namespace
}  // namespace tocsin
