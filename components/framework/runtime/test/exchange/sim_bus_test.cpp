// SPDX-License-Identifier: Apache-2.0
#include "runtime/sim_bus.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

/// Answers each goal with a status, and counts ticks.
class Echo : public Component {
 public:
  explicit Echo(Context& context) : Component(context) {}
  void tick(Time now) override {
    ticks.push_back(now);
    while (const auto goal = goal_.take()) {
      tocsin_msgs::msg::NavigationStatus status;
      status.stamp(wall(now));
      status.goal_id(goal->id());
      EXPECT_EQ(status_.write(status), Status::ok);
    }
    if (again_at) wake_at(*again_at);
    again_at.reset();
  }
  void every(Duration period) { wake_every(period); }
  std::vector<Time> ticks;
  std::optional<Time> again_at;

 private:
  Input<topic::Goal> goal_{*this};
  Output<topic::NavigationStatus> status_{*this};
};

class SimBusTest : public ::testing::Test {
 protected:
  SimBus bus_;
  Context context_{bus_, "echo", Role::uxv};
};

/// The name of a topic with another type.
struct OtherGoal {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"goal", "command", Scope::link};
};

tocsin_msgs::msg::Goal goal(std::uint64_t id) {
  tocsin_msgs::msg::Goal message;
  message.id(id);
  return message;
}

TEST_F(SimBusTest, TicksOnceAtStart) {
  Echo sut(context_);
  bus_.add(sut);
  bus_.run_for(seconds(10));
  EXPECT_EQ(sut.ticks.size(), 1U);
}

/// Ends the life of another component in its third tick.
class Ender : public Component {
 public:
  Ender(Context& context, SimBus& bus, std::unique_ptr<Echo>& other)
      : Component(context), bus_(bus), other_(other) {
    wake_every(seconds(1));
  }
  void tick(Time) override {
    if (++ticks_ < 3 || !other_) return;
    bus_.remove(*other_);
    other_.reset();
  }

 private:
  SimBus& bus_;
  std::unique_ptr<Echo>& other_;
  int ticks_ = 0;
};

TEST_F(SimBusTest, AComponentMayBeRemovedByTheTickOfAnother) {
  auto before = std::make_unique<Echo>(context_);
  auto after = std::make_unique<Echo>(context_);
  Ender first(context_, bus_, before);
  Ender second(context_, bus_, after);
  Echo last(context_);
  for (Component* component :
       {static_cast<Component*>(before.get()), static_cast<Component*>(&first),
        static_cast<Component*>(&second), static_cast<Component*>(after.get()),
        static_cast<Component*>(&last)}) {
    bus_.add(*component);
  }
  last.every(seconds(1));
  bus_.run_for(seconds(5));
  bus_.publish<topic::Goal>(goal(1));
  bus_.run_for(seconds(5));
  EXPECT_FALSE(before);
  EXPECT_FALSE(after);
  EXPECT_GE(last.ticks.size(), 10U);
}

TEST_F(SimBusTest, WakesOnInputAndDeliversTheAnswer) {
  Echo sut(context_);
  SimReader<topic::NavigationStatus> answers(bus_);
  bus_.add(sut);
  bus_.publish<topic::Goal>(goal(7));
  bus_.run_for(Duration::zero());
  const auto taken = answers.take();
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].goal_id(), 7U);
  EXPECT_EQ(taken[0].stamp().sec(), 1'767'225'600);
}

TEST_F(SimBusTest, WakesExactlyAtTheDeadline) {
  Echo sut(context_);
  const Time start = bus_.now();
  sut.again_at = start + seconds(0.25);
  bus_.add(sut);
  bus_.run_for(seconds(1));
  ASSERT_EQ(sut.ticks.size(), 2U);
  EXPECT_EQ(sut.ticks[1] - start, seconds(0.25));
}

TEST_F(SimBusTest, WakesPeriodically) {
  Echo sut(context_);
  sut.every(seconds(0.1));
  bus_.add(sut);
  bus_.run_for(seconds(1));
  EXPECT_EQ(sut.ticks.size(), 11U);
}

TEST_F(SimBusTest, LateReaderOfAStateTopicGetsTheLastSample) {
  Echo sut(context_);
  bus_.add(sut);
  bus_.publish<topic::Goal>(goal(7));
  bus_.run_for(Duration::zero());
  SimReader<topic::NavigationStatus> late(bus_);
  EXPECT_EQ(late.take().size(), 1U);
}

TEST_F(SimBusTest, LateReaderOfACommandTopicGetsNothing) {
  bus_.publish<topic::Goal>(goal(7));
  SimReader<topic::Goal> late(bus_);
  EXPECT_TRUE(late.take().empty());
}

/// A topic with the profile of a QoS file.
struct Latched {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"latched", "latched", Scope::host};
};

TEST(SimBus, KeepsForLateReadersWhatTheProfileOfItsFilePromises) {
  const TemporaryFolder folder;
  SimBus bus(QosProfiles(folder.write(
      "qos.yaml", "latched: {durability: transient_local, depth: 2, lifespan_s: 10}\n")));
  for (const char* text : {"one", "two", "three"}) {
    std_msgs::msg::String message;
    message.data(text);
    bus.publish<Latched>(message);
    bus.run_for(seconds(4));
  }
  SimReader<Latched> late(bus);
  const auto taken = late.take();
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].data(), "two");
  bus.run_for(seconds(4));
  SimReader<Latched> later(bus);
  EXPECT_EQ(later.take().size(), 1U) << "the second has outlived its lifespan";
}

TEST(SimBus, RefusesATopicWhoseProfileIsNotInItsFile) {
  const TemporaryFolder folder;
  SimBus bus(QosProfiles(folder.write("qos.yaml", "command: {depth: 1}\n")));
  EXPECT_THROW(SimReader<Latched>{bus}, ConfigError);
}

TEST(SimBus, AProfileOfAnotherNameIsAsDdsHasItByDefault) {
  SimBus bus;
  bus.publish<Latched>({});
  SimReader<Latched> late(bus);
  EXPECT_TRUE(late.take().empty());
  bus.publish<Latched>({});
  EXPECT_EQ(late.take().size(), 1U);
}

TEST_F(SimBusTest, WhatAWriterThatIsGoneWroteIsNotKept) {
  {
    SimWriter<topic::NavigationStatus> writer(bus_);
    EXPECT_EQ(writer.write({}), Status::ok);
  }
  SimReader<topic::NavigationStatus> late(bus_);
  EXPECT_TRUE(late.take().empty());
}

TEST_F(SimBusTest, RefusesTwoTypesOnOneTopic) {
  Echo sut(context_);
  EXPECT_THROW(SimReader<OtherGoal>{bus_}, ConfigError);
}

}  // namespace
}  // namespace tocsin
