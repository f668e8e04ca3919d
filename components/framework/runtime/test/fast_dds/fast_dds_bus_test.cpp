// SPDX-License-Identifier: Apache-2.0
// Real Fast DDS over real UDP on loopback. Each test has DDS domains of its own.
#include "runtime/middleware/fast_dds_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "runner/tick_time.hpp"
#include "runtime/host_control.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

template <class Topic>
Endpoint endpoint() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

class FastDdsBusTest : public ::testing::Test {
 protected:
  /// A domain of this test's own, apart from those of other processes running now.
  static int domain() {
    static int next = 100;
    return ++next;
  }
  /// A process of a host.
  static std::unique_ptr<Bus> make(Role role, int domain, const std::string& vehicle = "") {
    const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/";
    BusOptions options;
    options.name = to_string(role);
    options.role = role;
    options.qos_file = config + "qos.yaml";
    options.traffic_file = config + "traffic.yaml";
    options.host_domain = domain;
    options.vehicle = vehicle;
    return make_fast_dds_bus(options);
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

TEST_F(FastDdsBusTest, ATopicReachesAnotherProcessOfItsHostAndNoOtherHost) {
  const int host = domain();
  const auto writer_bus = make(Role::uxv, host);
  const auto reader_bus = make(Role::uxv, host);
  const auto gcs = make(Role::gcs, domain());
  Samples near;
  Samples far;
  const auto near_reader = reader_bus->subscribe(endpoint<topic::Location>(), near);
  const auto far_reader = gcs->subscribe(endpoint<topic::Location>(), far);
  const auto writer = writer_bus->advertise(endpoint<topic::Location>());
  write_until_heard<topic::Location>(*writer, near);
  EXPECT_TRUE(far.all().empty()) << "only a link_router crosses";
  const Sample sample = near.all().front();
  EXPECT_GT(sample.sequence, 0U);
  EXPECT_GT(sample.bytes, 300U);
  EXPECT_LE(sample.sent_wall_ns, sample.received_wall_ns);
}

TEST_F(FastDdsBusTest, ProcessesOfTwoVehiclesAtAStationDoNotFindEachOther) {
  const int station = domain();
  const auto writer_bus = make(Role::uxv, station, "uxv1");
  const auto own_bus = make(Role::uxv, station, "uxv1");
  const auto others_bus = make(Role::uxv, station, "uxv2");
  const auto site_bus = make(Role::uxv, station);
  Samples own;
  Samples others;
  Samples site;
  const auto own_reader = own_bus->subscribe(endpoint<topic::Location>(), own);
  const auto others_reader = others_bus->subscribe(endpoint<topic::Location>(), others);
  const auto site_reader = site_bus->subscribe(endpoint<topic::Location>(), site);
  const auto writer = writer_bus->advertise(endpoint<topic::Location>());
  const auto others_writer = others_bus->advertise(endpoint<topic::Location>());
  write_until_heard<topic::Location>(*writer, own);
  write_until_heard<topic::Location>(*writer, site);  // which serves all
  EXPECT_TRUE(others.all().empty());
  own.clear();
  site.clear();
  write_until_heard<topic::Location>(*others_writer, site);
  EXPECT_TRUE(own.all().empty());
}

TEST_F(FastDdsBusTest, WhatTheEnvironmentSaysToFastDdsOfRos2HasNoEffect) {
  const auto self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string environment =
      "ROS_DISCOVERY_SERVER=127.0.0.1:11811 FASTRTPS_DEFAULT_PROFILES_FILE=/nowhere.xml ";
  const std::string test = "FastDdsBusTest.ATopicReachesAnotherProcessOfItsHostAndNoOtherHost";
  EXPECT_EQ(std::system((environment + self + " --gtest_filter=" + test).c_str()), 0);
}

TEST_F(FastDdsBusTest, ReadersInTheProcessGetTheVeryObjectOnce) {
  const auto bus = make(Role::gcs, domain());
  Samples own;
  const auto own_reader = bus->subscribe(endpoint<topic::Goal>(), own);
  const auto writer = bus->advertise(endpoint<topic::Goal>());
  const auto message = goal(1);
  ASSERT_EQ(writer->write(message), Status::ok);
  ASSERT_EQ(writer->write(goal(2)), Status::ok);
  ASSERT_TRUE(own.wait_for(2));
  EXPECT_EQ(own.all().size(), 2U);
  EXPECT_EQ(own.all()[0].message, message);
}

TEST_F(FastDdsBusTest, WhatATickWritesHasTheTimeOfTheTickAndOtherThingsTheirOwn) {
  const auto bus = make(Role::gcs, domain());
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

TEST_F(FastDdsBusTest, LateReaderOfAStateTopicGetsTheLastSample) {
  const int host = domain();
  const auto uxv = make(Role::uxv, host);
  const auto writer = uxv->advertise(endpoint<topic::TransmissionState>());
  auto message = std::make_shared<tocsin_msgs::msg::TransmissionState>();
  message->decision(42);
  ASSERT_EQ(writer->write(message), Status::ok);
  const auto later = make(Role::uxv, host);
  Samples collector;
  const auto reader = later->subscribe(endpoint<topic::TransmissionState>(), collector);
  ASSERT_TRUE(collector.wait_for(1));
  EXPECT_EQ(std::static_pointer_cast<const tocsin_msgs::msg::TransmissionState>(
                collector.all()[0].message)
                ->decision(),
            42U);
}

TEST_F(FastDdsBusTest, MissingProfileIsAConfigErrorNamingTheTopic) {
  const auto bus = make(Role::uxv, domain());
  Endpoint wrong = endpoint<topic::Goal>();
  wrong.topic.qos = "nonsense";
  Samples collector;
  EXPECT_THROW((void)bus->subscribe(wrong, collector), ConfigError);
  EXPECT_TRUE(bus->host_control().health().empty()) << "the bus goes on without it";
}

TEST_F(FastDdsBusTest, ALinkTopicWithoutATrafficClassIsAConfigErrorNamingIt) {
  const auto bus = make(Role::gcs, domain());
  EXPECT_THROW((void)bus->advertise(endpoint<topic::Location>()), ConfigError)
      << "the station writes no location";
}

}  // namespace
}  // namespace tocsin
