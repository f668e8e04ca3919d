// SPDX-License-Identifier: Apache-2.0
// Real Fast DDS over real UDP on loopback. Each test has DDS domains of its own.
#include "runtime/middleware/fast_dds_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "fast_dds/rtps_capture.hpp"
#include "foundation/error.hpp"
#include "runner/tick_time.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

template <class Topic>
Endpoint endpoint() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

class FastDdsBusTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { deliver_by_packets(); }

  /// Three domains of this test's own, apart from those of other processes running now.
  static int domain() {
    static int next = 100;
    return next += 3;
  }
  static std::unique_ptr<Bus> make(const std::string& role, int first_domain, int side) {
    const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/";
    return make_fast_dds_bus({role,
                              role,
                              "",
                              config + "qos.yaml",
                              config + "traffic_thesis.yaml",
                              first_domain + side,
                              first_domain + 2,
                              "127.0.0.1",
                              {"127.0.0.1"},
                              60});
  }

  /// Writes until `collector` has heard the writer: discovery is over then.
  template <class Topic>
  static void write_until_heard(Publication& publication, Samples& collector) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (collector.all().empty() && std::chrono::steady_clock::now() < end) {
      (void)publication.write(std::make_shared<const typename Topic::Message>());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_FALSE(collector.all().empty()) << "not discovered";
  }
  static std::shared_ptr<const tocsin_msgs::msg::Goal> goal(std::uint64_t id) {
    auto message = std::make_shared<tocsin_msgs::msg::Goal>();
    message->id(id);
    return message;
  }
};

TEST_F(FastDdsBusTest, LinkTopicReachesTheOtherSide) {
  const int first = domain();
  const auto uxv = make("uxv", first, 0);
  const auto gcs = make("gcs", first, 1);
  Samples collector;
  const auto reader = gcs->subscribe(endpoint<topic::Location>(), collector);
  const auto writer = uxv->advertise(endpoint<topic::Location>());
  write_until_heard<topic::Location>(*writer, collector);
  const Sample sample = collector.all().front();
  EXPECT_GT(sample.sequence, 0U);
  EXPECT_GT(sample.bytes, 300U);
  EXPECT_LE(sample.sent_wall_ns, sample.received_wall_ns);
}

TEST_F(FastDdsBusTest, HostTopicReachesAnotherProcessOfTheHostButNotTheOtherSide) {
  const int first = domain();
  const auto writer_bus = make("uxv", first, 0);
  const auto reader_bus = make("uxv", first, 0);
  const auto gcs = make("gcs", first, 1);
  Samples near;
  Samples far;
  const auto near_reader = reader_bus->subscribe(endpoint<topic::CmdVel>(), near);
  const auto far_reader = gcs->subscribe(endpoint<topic::CmdVel>(), far);
  const auto writer = writer_bus->advertise(endpoint<topic::CmdVel>());
  write_until_heard<topic::CmdVel>(*writer, near);
  EXPECT_TRUE(far.all().empty());
}

TEST_F(FastDdsBusTest, ReadersInTheProcessGetTheVeryObjectOnce) {
  const auto bus = make("uxv", domain(), 0);
  Samples collector;
  const auto reader = bus->subscribe(endpoint<topic::Goal>(), collector);
  const auto gcs_rules = make("gcs", domain(), 1);
  Samples own;
  const auto own_reader = gcs_rules->subscribe(endpoint<topic::Goal>(), own);
  const auto writer = gcs_rules->advertise(endpoint<topic::Goal>());
  const auto message = goal(1);
  ASSERT_EQ(writer->write(message), Status::ok);
  ASSERT_EQ(writer->write(goal(2)), Status::ok);
  ASSERT_TRUE(own.wait_for(2));
  EXPECT_EQ(own.all().size(), 2U);
  EXPECT_EQ(own.all()[0].message, message);
}

TEST_F(FastDdsBusTest, WhatATickWritesHasTheTimeOfTheTickAndOtherThingsTheirOwn) {
  const auto bus = make("gcs", domain(), 1);
  Samples collector;
  const auto reader = bus->subscribe(endpoint<topic::Goal>(), collector);
  const auto writer = bus->advertise(endpoint<topic::Goal>());
  const Time before = bus->now();
  const Time tick = before - std::chrono::milliseconds(5);
  {
    const TickTime time(tick);
    ASSERT_EQ(writer->write(goal(1)), Status::ok);
  }
  ASSERT_EQ(writer->write(goal(2)), Status::ok);
  const auto samples = collector.all();
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].received, tick);
  EXPECT_GE(samples[1].received, before);
  EXPECT_GE(samples[1].received_wall_ns - samples[0].received_wall_ns, 5'000'000);
  EXPECT_EQ(samples[1].sequence, samples[0].sequence + 1);
}

TEST_F(FastDdsBusTest, LateReaderOfAStateTopicGetsTheLastSampleAcrossTheLink) {
  const int first = domain();
  const auto uxv = make("uxv", first, 0);
  const auto writer = uxv->advertise(endpoint<topic::TransmissionState>());
  auto message = std::make_shared<tocsin_msgs::msg::TransmissionState>();
  message->decision(42);
  ASSERT_EQ(writer->write(message), Status::ok);
  const auto gcs = make("gcs", first, 1);
  Samples collector;
  const auto reader = gcs->subscribe(endpoint<topic::TransmissionState>(), collector);
  ASSERT_TRUE(collector.wait_for(1));
  EXPECT_EQ(std::static_pointer_cast<const tocsin_msgs::msg::TransmissionState>(
                collector.all()[0].message)
                ->decision(),
            42U);
}

TEST_F(FastDdsBusTest, MissingProfileIsAConfigErrorNamingTheTopic) {
  const auto bus = make("uxv", domain(), 0);
  Endpoint wrong = endpoint<topic::Goal>();
  wrong.topic.qos = "nonsense";
  Samples collector;
  EXPECT_THROW((void)bus->subscribe(wrong, collector), ConfigError);
  EXPECT_TRUE(bus->health().empty()) << "the bus goes on without it";
  bus->set_gate(false);
}

TEST_F(FastDdsBusTest, GateDropsTheLowClassAndDeliversTheNewestGoalOnResume) {
  const int first = domain();
  const auto uxv = make("uxv", first, 0);
  const auto gcs = make("gcs", first, 1);
  Samples goals;
  const auto reader = uxv->subscribe(endpoint<topic::Goal>(), goals);
  const auto writer = gcs->advertise(endpoint<topic::Goal>());
  write_until_heard<topic::Goal>(*writer, goals);
  gcs->set_gate(false);
  goals.clear();
  EXPECT_EQ(writer->write(goal(7)), Status::paused);
  EXPECT_EQ(writer->write(goal(8)), Status::paused);
  gcs->set_gate(true);
  ASSERT_TRUE(goals.wait_for(1));
  const auto last = goals.all().back();
  EXPECT_EQ(std::static_pointer_cast<const tocsin_msgs::msg::Goal>(last.message)->id(), 8U);
}

/// Submessages that a user's writer sent.
std::vector<CapturedSubmessage> of_user_writers(const std::vector<CapturedSubmessage>& all,
                                                std::uint16_t link_port_base) {
  std::vector<CapturedSubmessage> some;
  for (const CapturedSubmessage& one : all) {
    const bool from_writer = one.kind == 0x15 || one.kind == 0x16 || one.kind == 0x07;
    const bool on_link = one.port >= link_port_base && one.port < link_port_base + 250;
    if (from_writer && on_link && !one.builtin()) some.push_back(one);
  }
  return some;
}

std::size_t endpoint_discoveries(const std::vector<CapturedSubmessage>& all, std::uint16_t base) {
  std::size_t count = 0;
  for (const CapturedSubmessage& one : all) {
    const bool sedp = one.writer == 0x000003c2 || one.writer == 0x000004c2;
    const bool on_link = one.port >= base && one.port < base + 250;
    if (one.kind == 0x15 && sedp && on_link) ++count;
  }
  return count;
}

TEST_F(FastDdsBusTest, APausedWriterIsSilentOnTheWireForFiveSecondsAndResumesWithoutDiscovery) {
  RtpsCapture capture;
  if (!capture.ok()) GTEST_SKIP() << "no packet socket: needs CAP_NET_RAW";
  const int first = domain();
  const auto link_ports = static_cast<std::uint16_t>(7400 + 250 * (first + 2));
  const auto uxv = make("uxv", first, 0);
  const auto gcs = make("gcs", first, 1);
  Samples goals;
  Samples images;
  const auto goal_reader = uxv->subscribe(endpoint<topic::Goal>(), goals);
  const auto image_reader = gcs->subscribe(endpoint<topic::CameraImage>(), images);
  const auto goal_writer = gcs->advertise(endpoint<topic::Goal>());
  const auto image_writer = uxv->advertise(endpoint<topic::CameraImage>());
  write_until_heard<topic::Goal>(*goal_writer, goals);
  write_until_heard<topic::CameraImage>(*image_writer, images);
  auto large = std::make_shared<sensor_msgs::msg::CompressedImage>();
  large->data().resize(40'000);
  (void)goal_writer->write(goal(1));
  (void)image_writer->write(large);
  gcs->set_gate(false);
  uxv->set_gate(false);
  EXPECT_FALSE(of_user_writers(capture.take(), link_ports).empty()) << "the capture sees nothing";

  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < end) {
    EXPECT_EQ(goal_writer->write(goal(2)), Status::paused);
    EXPECT_EQ(image_writer->write(large), Status::paused);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_EQ(of_user_writers(capture.take(), link_ports).size(), 0U);
  goals.clear();
  gcs->set_gate(true);
  uxv->set_gate(true);
  ASSERT_TRUE(goals.wait_for(1));
  const auto after = capture.take();
  EXPECT_FALSE(of_user_writers(after, link_ports).empty());
  EXPECT_EQ(endpoint_discoveries(after, link_ports), 0U);
}

TEST_F(FastDdsBusTest, LinkMessagesFitOneUnfragmentedPacket) {
  RtpsCapture capture;
  if (!capture.ok()) GTEST_SKIP() << "no packet socket: needs CAP_NET_RAW";
  const int first = domain();
  const auto link_ports = static_cast<std::uint16_t>(7400 + 250 * (first + 2));
  const auto uxv = make("uxv", first, 0);
  const auto gcs = make("gcs", first, 1);
  Samples images;
  const auto reader = gcs->subscribe(endpoint<topic::CameraImage>(), images);
  const auto writer = uxv->advertise(endpoint<topic::CameraImage>());
  write_until_heard<topic::CameraImage>(*writer, images);
  images.clear();
  auto large = std::make_shared<sensor_msgs::msg::CompressedImage>();
  large->data().resize(40'000);
  ASSERT_EQ(writer->write(large), Status::ok);
  ASSERT_TRUE(images.wait_for(1));
  std::size_t fragments = 0;
  for (const CapturedSubmessage& one : of_user_writers(capture.take(), link_ports)) {
    EXPECT_LE(one.packet_bytes, 1400U + 28U);
    fragments += one.kind == 0x16 ? 1 : 0;
  }
  EXPECT_GE(fragments, 29U);
}

}  // namespace
}  // namespace tocsin
