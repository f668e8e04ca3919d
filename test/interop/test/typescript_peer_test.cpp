// SPDX-License-Identifier: Apache-2.0
// A third implementation of RTPS, in TypeScript (test/rtps_peer), as a ROS 2 node beside ours: it
// finds our participants, lists our nodes and topics, and decodes samples. It acknowledges topics
// at the address of discovery, where a writer of Fast DDS does not hear it: nothing is repaired for
// it, and it gets no samples of before. Skipped where it was not installed (npm ci in
// test/rtps_peer).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <ros_idl/nav_msgs.hpp>
#include <ros_idl/sensor_msgs.hpp>
#include <ros_idl/std_msgs.hpp>

#include "peer_process.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::interop {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;
using Image = sensor_msgs::msg::CompressedImage;
using Map = nav_msgs::msg::OccupancyGrid;
using Odometry = nav_msgs::msg::Odometry;
using String = std_msgs::msg::String;

constexpr int domain = 155;
constexpr std::size_t picture_bytes = 300'000;  // 5 fragments
const std::string peer = std::string(TOCSIN_REPOSITORY) + "/test/rtps_peer";

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) {
    text += part.data();
  }
  return text;
}

json want(const std::string& type, bool reliable, bool state, int count) {
  return {{"type", type}, {"reliable", reliable}, {"state", state}, {"count", count}};
}

/// A vehicle of ours that writes one topic of each kind.
class Vehicle {
 public:
  Vehicle()
      : bus_(make_fast_dds_bus(options())),
        chatter_(bus_->advertise(end<String>("chatter", "event"))),
        odometry_(bus_->advertise(end<Odometry>("odom", "sensor"))),
        pictures_(bus_->advertise(end<Image>("camera", "stream"))),
        map_(bus_->advertise(end<Map>("map", "state"))) {}
  void write(int number) {
    auto text = std::make_shared<String>();
    text->data("Grüße " + std::to_string(number));
    (void)chatter_->write(text);
    auto odometry = std::make_shared<Odometry>();
    odometry->header().frame_id("odom");
    odometry->pose().pose().position().x(1.25);
    odometry->pose().covariance()[35] = 1e-6;
    (void)odometry_->write(odometry);
    auto image = std::make_shared<Image>();
    image->format("jpeg");
    image->data().assign(picture_bytes, 7);
    (void)pictures_->write(image);
    auto map = std::make_shared<Map>();
    map->info().width(3);
    map->info().height(2);
    map->info().resolution(0.05F);
    map->data({0, 100, -1, 0, 0, 100});
    (void)map_->write(map);
    bus_->host_control().update_graph();
  }

 private:
  static BusOptions options() {
    BusOptions options;
    options.name = "vehicle";
    options.host_domain = domain;
    options.ros_namespace = "uxv";
    return options;
  }
  template <class Message>
  static Endpoint end(const char* topic, const char* qos) {
    return {{topic, qos, Scope::host}, &type_info<Message>(), Writers::needed, "", "writer"};
  }
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Publication> chatter_;
  std::unique_ptr<Publication> odometry_;
  std::unique_ptr<Publication> pictures_;
  std::unique_ptr<Publication> map_;
};

void expect_messages(const json& messages) {
  EXPECT_THAT(messages.at("/uxv/chatter").at(0).at("data").get<std::string>(), HasSubstr("Grüße "));
  const json& pose = messages.at("/uxv/odom").at(0).at("pose");
  EXPECT_EQ(pose.at("pose").at("position").at("x"), 1.25);
  EXPECT_EQ(pose.at("covariance").at(35), 1e-6);
  const json& image = messages.at("/uxv/camera").at(0);
  EXPECT_EQ(image.at("format"), "jpeg");
  EXPECT_EQ(image.at("data").at("bytes"), picture_bytes);
  EXPECT_EQ(image.at("data").at("sum"), picture_bytes * 7 % 65536);
  const json& map = messages.at("/uxv/map");
  ASSERT_EQ(map.size(), 1U);
  EXPECT_EQ(map.at(0).at("info").at("width"), 3);
  EXPECT_EQ(map.at(0).at("data"), json({0, 100, -1, 0, 0, 100}));
}

TEST(TypeScriptPeer, ListsOurNodesAndTopicsAndReadsThem) {
  if (!std::filesystem::exists(peer + "/node_modules/@foxglove/rtps")) {
    GTEST_SKIP() << "@foxglove/rtps is not installed: npm ci in test/rtps_peer";
  }
  if (output_of("node --version 2>/dev/null").empty()) GTEST_SKIP() << "there is no node";
  const OtherComputer cable;  // it announces itself by multicast only, wherever that is routed to
  if (!cable.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  ASSERT_TRUE(shell("ip route add 239.255.0.0/16 dev eth0"));
  Vehicle vehicle;
  const json wanted{{"/uxv/chatter", want("std_msgs/String", true, false, 3)},
                    {"/uxv/odom", want("nav_msgs/Odometry", false, false, 3)},
                    {"/uxv/camera", want("sensor_msgs/CompressedImage", true, false, 2)},
                    {"/uxv/map", want("nav_msgs/OccupancyGrid", true, true, 1)}};
  auto said = std::async(std::launch::async, [&] {
    return output_of("node " + peer + "/client.mjs " + std::to_string(domain) + " 60 '" +
                     wanted.dump() + "' 2>&1");
  });
  for (int number = 1; said.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready;
       ++number) {
    vehicle.write(number);
  }
  const std::string text = said.get();
  const json seen = json::parse(text, nullptr, false);
  ASSERT_FALSE(seen.is_discarded()) << text;
  EXPECT_EQ(seen.at("end"), "done") << text;
  EXPECT_EQ(seen.at("undecoded"), json::array()) << text;
  EXPECT_THAT(seen.at("participants"), Contains(HasSubstr("enclave=/;")));
  EXPECT_THAT(seen.at("nodes"), Contains("/uxv/writer"));
  const json& topics = seen.at("topics");
  EXPECT_EQ(topics.value("/uxv/odom", ""), "nav_msgs/msg/Odometry");
  EXPECT_EQ(topics.value("/uxv/camera", ""), "sensor_msgs/msg/CompressedImage");
  expect_messages(seen.at("messages"));
}

}  // namespace
}  // namespace tocsin::interop
