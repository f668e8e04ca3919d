// SPDX-License-Identifier: Apache-2.0
#include "scheduler.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "runtime/sim_bus.hpp"

namespace tocsin::simulation {
namespace {

constexpr Time begin{std::chrono::seconds(10)};

/// Does in its tick what the test says.
class Puppet final : public Component {
 public:
  using Act = std::function<void(Puppet&, Time)>;
  Puppet(Context& context, Act act) : Component(context), act_(std::move(act)) {}
  void tick(Time now) override {
    ++ticks;
    act_(*this, now);
  }
  using Component::wake_at;
  int ticks = 0;

 private:
  Act act_;
};

class SchedulerTest : public ::testing::Test {
 protected:
  void add(Puppet& puppet) {
    sut_.add(puppet, [this] { return running_; });
  }
  SimBus bus_;
  Context context_{bus_, "puppet", Role::uxv};
  bool running_ = true;
  Scheduler sut_;
};

TEST_F(SchedulerTest, TicksOnceAtItsStart) {
  Puppet puppet(context_, [](Puppet&, Time) {});
  Puppet later(context_, [](Puppet&, Time) {});
  add(puppet);
  sut_.add(
      later, [] { return true; }, begin + seconds(1));
  sut_.run(begin);
  EXPECT_EQ(puppet.ticks, 1);
  EXPECT_EQ(later.ticks, 0);
  EXPECT_EQ(sut_.next(), begin + seconds(1));
  sut_.run(begin + seconds(1));
  EXPECT_EQ(puppet.ticks, 1);
  EXPECT_EQ(later.ticks, 1);
  EXPECT_EQ(sut_.ticks(), 2U);
  EXPECT_EQ(sut_.next(), never);
}

TEST_F(SchedulerTest, WhoIsFrozenIsNotDueAndTicksOnceWhenItIsThawed) {
  Puppet puppet(context_, [](Puppet& p, Time now) { p.wake_at(now + seconds(1)); });
  add(puppet);
  sut_.run(begin);
  sut_.freeze(puppet, true);
  EXPECT_EQ(sut_.next(), never);
  sut_.run(begin + seconds(5));
  EXPECT_EQ(puppet.ticks, 1);
  sut_.freeze(puppet, false);
  sut_.run(begin + seconds(6));
  EXPECT_EQ(puppet.ticks, 2);
  EXPECT_EQ(sut_.next(), begin + seconds(7));
}

TEST_F(SchedulerTest, TicksAtADeadlineAndNotBeforeWhileItsProcessLives) {
  Puppet puppet(context_, [](Puppet& p, Time now) { p.wake_at(now + seconds(1)); });
  add(puppet);
  sut_.run(begin);
  EXPECT_EQ(sut_.next(), begin + seconds(1));
  sut_.run(begin + seconds(1) - Duration{1});
  EXPECT_EQ(puppet.ticks, 1);
  sut_.run(begin + seconds(1));
  EXPECT_EQ(puppet.ticks, 2);
  running_ = false;
  sut_.run(begin + seconds(2));
  EXPECT_EQ(puppet.ticks, 2);
  EXPECT_EQ(sut_.next(), never);
}

TEST_F(SchedulerTest, TicksForInputUntilAllAreAtRest) {
  Puppet second(context_, [](Puppet&, Time) {});
  Puppet first(context_, [&](Puppet& p, Time) {
    if (p.ticks == 2) second.schedule().input_arrived();
  });
  add(second);
  add(first);
  sut_.run(begin);
  first.schedule().input_arrived();
  sut_.run(begin);
  EXPECT_EQ(first.ticks, 2);
  EXPECT_EQ(second.ticks, 2);
}

TEST_F(SchedulerTest, ComponentThatThrowsIsTickedNoMoreAndItsNeighbourIs) {
  Puppet bad(context_, [](Puppet& p, Time now) {
    p.wake_at(now + seconds(1));
    throw std::runtime_error("planned");
  });
  Puppet good(context_, [](Puppet& p, Time now) { p.wake_at(now + seconds(1)); });
  add(bad);
  add(good);
  sut_.run(begin);
  sut_.run(begin + seconds(1));
  EXPECT_EQ(bad.ticks, 1);
  EXPECT_EQ(good.ticks, 2);
}

TEST_F(SchedulerTest, NamesAComponentThatNeverComesToRest) {
  Puppet puppet(context_, [](Puppet& p, Time now) { p.wake_at(now); });
  add(puppet);
  try {
    sut_.run(begin);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("puppet"), std::string::npos);
  }
}

}  // namespace
}  // namespace tocsin::simulation
