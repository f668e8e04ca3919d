// SPDX-License-Identifier: Apache-2.0
// A host's domain as commands use it, on real DDS.
#include "topic_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "foundation/error.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
using String = std_msgs::msg::String;

const Endpoint news{{"news", "event", Scope::host}, &type_info<String>()};

class TopicSessionTest : public ::testing::Test {
 protected:
  TopicSessionTest() : domain_(++last_domain), neighbour_(make_fast_dds_bus(options())) {
    choice_.domain = domain_;
  }
  [[nodiscard]] BusOptions options() const {
    BusOptions options;
    options.name = "neighbour";
    options.qos_file = TOCSIN_REPOSITORY "/config/qos.yaml";
    options.host_domain = domain_;
    return options;
  }
  static std::shared_ptr<const String> text(const std::string& data) {
    auto made = std::make_shared<String>();
    made->data(data);
    return made;
  }
  static inline int last_domain = 94;
  const int domain_;
  HostChoice choice_;
  std::unique_ptr<Bus> neighbour_;
};

TEST_F(TopicSessionTest, FindsATopicThatAppearsWhileItWaits) {
  TopicSession sut({choice_, 5});
  std::unique_ptr<Publication> writer;
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    writer = neighbour_->advertise(news);
  });
  const RawTopic topic = sut.find("/news");
  late.join();
  EXPECT_EQ(topic.name, "rt/news");
  EXPECT_EQ(topic.type, "std_msgs::msg::dds_::String_");
  EXPECT_TRUE(topic.reliable);
}

TEST_F(TopicSessionTest, GivesUpOnATopicThatNobodyHas) {
  const TopicSession sut({choice_, 0.2});
  EXPECT_THROW((void)sut.find("/news"), EnvironmentError);
  EXPECT_TRUE(sut.ends().empty());
}

TEST_F(TopicSessionTest, SamplesWaitForWhoPrintsAndTheOldestMakesRoom) {
  TopicSession sut({choice_, 5});
  const auto writer = neighbour_->advertise(news);
  SampleQueue samples(sut.graph(), sut.find("/news"));
  std::optional<RawSample> first;
  for (int i = 0; i < 100 && !first; ++i) {
    (void)writer->write(text("first"));
    first = samples.take(std::chrono::milliseconds(50));
  }
  ASSERT_TRUE(first);
  for (int i = 0; i < 1100; ++i) {
    ASSERT_EQ(writer->write(text("many")), Status::ok);
    if (i % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  for (int i = 0; i < 500 && samples.dropped() < 50; ++i) {
    (void)writer->write(text("more"));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_GE(samples.dropped(), 50U);
  std::size_t waiting = 0;
  while (samples.take(std::chrono::milliseconds(1))) ++waiting;
  EXPECT_GE(waiting, 900U);
}

TEST(KnownType, IsThatOfAnInstalledPackageOrAnErrorInWordsOfRos2) {
  EXPECT_STREQ(known_type("std_msgs::msg::dds_::String_").name, "std_msgs::msg::dds_::String_");
  try {
    (void)known_type("no_msgs::msg::dds_::Thing_");
    FAIL() << "it is not known";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("'no_msgs/msg/Thing' is not known here"));
  }
}

}  // namespace
}  // namespace tocsin::topic_tool
