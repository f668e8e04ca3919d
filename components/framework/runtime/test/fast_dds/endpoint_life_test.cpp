// SPDX-License-Identifier: Apache-2.0
// DDS endpoints live as long as a port of this process uses them: a component that is unloaded
// leaves nothing behind. Real Fast DDS on loopback.
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using Message = tocsin_msgs::msg::Goal;

class EndpointLifeTest : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 180;
    return ++next;
  }
  static std::shared_ptr<const Message> goal(std::uint64_t id) {
    auto message = std::make_shared<Message>();
    message->id(id);
    return message;
  }
  static std::vector<std::uint64_t> ids(Samples& samples) {
    std::vector<std::uint64_t> ids;
    for (const Sample& one : samples.all()) {
      ids.push_back(static_cast<const Message*>(one.message.get())->id());
    }
    return ids;
  }
  [[nodiscard]] int matched(Bus& bus, bool writer) const {
    return health_of(bus, topic_.topic.name, writer).matched;
  }

  const Endpoint topic_{{"goals", "goals", Scope::host}, &type_info<Message>()};
  const std::string qos_ = "goals: {reliability: reliable, durability: transient_local}\n";
  const int domain_ = domain();
  const std::unique_ptr<Bus> near_ = make_test_bus(domain_, qos_);
  const std::unique_ptr<Bus> far_ = make_test_bus(domain_, qos_);
};

TEST_F(EndpointLifeTest, AReaderLeavesWithTheLastSubscription) {
  Samples one;
  Samples two;
  const auto writer = far_->advertise(topic_);
  auto first = near_->subscribe(topic_, one);
  auto second = near_->subscribe(topic_, two);
  ASSERT_TRUE(eventually([&] { return matched(*far_, true) == 1; }));
  first.reset();
  ASSERT_EQ(writer->write(goal(1)), Status::ok);
  EXPECT_TRUE(two.wait_for(1));
  second.reset();
  EXPECT_TRUE(eventually([&] { return matched(*far_, true) == 0; }));
}

TEST_F(EndpointLifeTest, WhatAWriterWroteLastArrivesThoughItsProcessEndsAtOnce) {
  constexpr std::size_t bursts = 20;
  constexpr std::size_t burst = 100;  // of 30 kB: more than the socket of a reader holds
  const std::string qos = "texts: {reliability: reliable, depth: 100, heartbeat_period_s: 0.02}\n";
  const Endpoint texts{{"texts", "texts", Scope::host}, &type_info<std_msgs::msg::String>()};
  const auto far = make_test_bus(domain_, qos);
  std_msgs::msg::String text;
  text.data(std::string(30'000, 'x'));
  const auto message = std::make_shared<const std_msgs::msg::String>(text);
  for (std::size_t i = 0; i < bursts; ++i) {
    Samples samples;
    const auto reader = far->subscribe(texts, samples);
    auto ending = make_test_bus(domain_, qos);
    auto writer = ending->advertise(texts);
    ASSERT_TRUE(eventually([&] { return health_of(*ending, "texts", true).matched == 1; }));
    for (std::size_t k = 0; k < burst; ++k) ASSERT_EQ(writer->write(message), Status::ok);
    writer.reset();
    ending.reset();
    ASSERT_TRUE(samples.wait_for(burst)) << samples.all().size() << " in burst " << i;
  }
}

TEST_F(EndpointLifeTest, AWriterLeavesWithTheLastPublication) {
  Samples samples;
  const auto reader = far_->subscribe(topic_, samples);
  auto first = near_->advertise(topic_);
  auto second = near_->advertise(topic_);
  ASSERT_TRUE(eventually([&] { return matched(*far_, false) == 1; }));
  first.reset();
  ASSERT_EQ(second->write(goal(1)), Status::ok);
  EXPECT_TRUE(samples.wait_for(1));
  second.reset();
  EXPECT_TRUE(eventually([&] { return matched(*far_, false) == 0; }));
}

TEST_F(EndpointLifeTest, WhoReadsAgainGetsTheStateOnce) {
  const auto writer = far_->advertise(topic_);
  ASSERT_EQ(writer->write(goal(1)), Status::ok);
  Samples before;
  auto reader = near_->subscribe(topic_, before);
  ASSERT_TRUE(before.wait_for(1));
  reader.reset();
  Samples again;
  reader = near_->subscribe(topic_, again);
  ASSERT_TRUE(again.wait_for(1));
  ASSERT_EQ(writer->write(goal(2)), Status::ok);
  ASSERT_TRUE(again.wait_for(2));
  EXPECT_EQ(ids(again), (std::vector<std::uint64_t>{1, 2}));
}

TEST_F(EndpointLifeTest, WhoReadsAgainDoesNotGetTheStateOfAWriterThatHasGone) {
  auto writer = far_->advertise(topic_);
  ASSERT_EQ(writer->write(goal(1)), Status::ok);
  Samples before;
  auto reader = near_->subscribe(topic_, before);
  ASSERT_TRUE(before.wait_for(1));
  reader.reset();
  writer.reset();
  Samples late;
  reader = near_->subscribe(topic_, late);
  writer = far_->advertise(topic_);
  ASSERT_EQ(writer->write(goal(2)), Status::ok);
  ASSERT_TRUE(late.wait_for(1));
  EXPECT_EQ(ids(late), std::vector<std::uint64_t>{2});
}

TEST_F(EndpointLifeTest, APublicationHasReadersWhileAnotherProcessReads) {
  const std::string qos = "goals: {reliability: reliable}\n";  // what is kept has always readers
  const int apart = domain();
  const auto near = make_test_bus(apart, qos);
  const auto far = make_test_bus(apart, qos);
  const auto writer = near->advertise(topic_);
  EXPECT_FALSE(writer->has_readers());
  Samples samples;
  auto reader = far->subscribe(topic_, samples);
  EXPECT_TRUE(eventually([&] { return writer->has_readers(); }));
  reader.reset();
  EXPECT_TRUE(eventually([&] { return !writer->has_readers(); }));
}

}  // namespace
}  // namespace tocsin
