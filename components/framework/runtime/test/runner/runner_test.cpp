// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/runner.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <stdexcept>

#include "runner/tick_time.hpp"

namespace tocsin {
namespace {

/// Real time, no topics.
class ClockBus : public Bus {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint&, Receiver&) override { return nullptr; }
  std::unique_ptr<Publication> advertise(const Endpoint&) override { return nullptr; }
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
  [[nodiscard]] std::int64_t wall_ns(Time) const override { return 0; }
};

class Counting : public Component {
 public:
  explicit Counting(Context& context) : Component(context) {}
  void tick(Time now) override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++ticks_;
    }
    changed_.notify_all();
    if (on_tick) on_tick(now);
  }
  bool wait_for_ticks(int wanted) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(10), [&] { return ticks_ >= wanted; });
  }
  int ticks() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ticks_;
  }
  void ask_at(Time t) { wake_at(t); }
  void watch(int fd) { wake_on(fd); }
  void unwatch(int fd) { forget(fd); }
  std::function<void(Time)> on_tick;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int ticks_ = 0;
};

class RunnerTest : public ::testing::Test {
 protected:
  static constexpr Duration patience = std::chrono::seconds(10);
  TickAccount account_;
  ClockBus bus_;
  Context context_{bus_, "counting", Role::uxv};
};

TEST_F(RunnerTest, TicksOnceAtStartThenOnInput) {
  Counting component(context_);
  Runner sut("test", bus_, component, account_);
  ASSERT_TRUE(component.wait_for_ticks(1));
  component.schedule().input_arrived();
  EXPECT_TRUE(component.wait_for_ticks(2));
}

TEST_F(RunnerTest, TicksAtADeadlineAndNotBefore) {
  Counting component(context_);
  std::vector<Time> at;
  Time asked{};
  component.on_tick = [&](Time now) {
    at.push_back(now);
    if (at.size() == 1) component.ask_at(asked = now + std::chrono::milliseconds(20));
  };
  {
    Runner sut("test", bus_, component, account_);
    ASSERT_TRUE(component.wait_for_ticks(2));
  }
  EXPECT_GE(at[1], asked);
}

TEST_F(RunnerTest, TicksWhenADescriptorIsReadable) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  Counting component(context_);
  component.watch(ends[0]);
  component.on_tick = [&](Time) {
    if (component.ticks() < 2) return;
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1), 1);
    component.unwatch(ends[0]);
  };
  {
    Runner sut("test", bus_, component, account_);
    ASSERT_TRUE(component.wait_for_ticks(1));
    ASSERT_EQ(write(ends[1], "x", 1), 1);
    EXPECT_TRUE(component.wait_for_ticks(2));
  }  // the tick that reads has ended
  close(ends[0]);
  close(ends[1]);
}

TEST_F(RunnerTest, ReportsAFailureOfAnyKindToItsOwner) {
  std::promise<void> failed;
  Counting bad(context_);
  bad.on_tick = [](Time) { throw 7; };
  Runner sut("test", bus_, bad, account_, [&failed] { failed.set_value(); });
  ASSERT_EQ(failed.get_future().wait_for(patience), std::future_status::ready);
  EXPECT_EQ(account_.read().error, "something that is no std::exception");
}

TEST_F(RunnerTest, TicksAComponentThatThrewNoMore) {
  Counting bad(context_);
  Counting good(context_);
  bad.on_tick = [](Time) { throw std::runtime_error("broken"); };
  TickAccount good_account;
  std::promise<void> failed;
  Runner sut("test", bus_, bad, account_, [&failed] { failed.set_value(); });
  const Runner neighbour("test", bus_, good, good_account);
  ASSERT_EQ(failed.get_future().wait_for(patience), std::future_status::ready);
  bad.schedule().input_arrived();
  good.schedule().input_arrived();
  EXPECT_TRUE(good.wait_for_ticks(1));
  EXPECT_TRUE(sut.stop(patience));
  EXPECT_EQ(bad.ticks(), 1);
  EXPECT_EQ(account_.read().error, "broken");
  EXPECT_FALSE(good_account.failed());
}

TEST_F(RunnerTest, AStoppedOneTicksNoMore) {
  Counting gone(context_);
  Runner sut("test", bus_, gone, account_);
  ASSERT_TRUE(gone.wait_for_ticks(1));
  ASSERT_TRUE(sut.stop(patience));
  const int ticks = gone.ticks();
  gone.schedule().input_arrived();
  EXPECT_EQ(gone.ticks(), ticks);
  EXPECT_TRUE(sut.stop(patience)) << "it is";
}

TEST_F(RunnerTest, DoesNotStopWhileATickDoesNotEndAndTicksOnThen) {
  std::promise<void> go_on;
  Counting blocked(context_);
  blocked.on_tick = [&](Time) {
    if (blocked.ticks() == 1) go_on.get_future().wait();
  };
  Runner sut("test", bus_, blocked, account_);
  ASSERT_TRUE(blocked.wait_for_ticks(1));
  EXPECT_FALSE(sut.stop(std::chrono::milliseconds(1)));
  EXPECT_TRUE(account_.read().running_since.has_value());
  go_on.set_value();
  blocked.schedule().input_arrived();
  EXPECT_TRUE(blocked.wait_for_ticks(2));
  EXPECT_TRUE(sut.stop(patience));
}

TEST_F(RunnerTest, TheTimeOfATickHoldsForItsWritesAndEndsWithIt) {
  Counting component(context_);
  Time given{};
  Time within{};
  std::promise<Time> later;
  component.on_tick = [&](Time now) {
    given = now;
    within = TickTime::now();
    throw std::runtime_error("on purpose");
  };
  const Runner sut("test", bus_, component, account_, [&] { later.set_value(TickTime::now()); });
  EXPECT_EQ(later.get_future().get(), never);
  EXPECT_EQ(within, given);
}

/// Many inputs from another thread: none may find the runner asleep for good.
TEST_F(RunnerTest, LosesNoWakeUp) {
  Counting component(context_);
  std::atomic<int> sent{0};
  std::atomic<int> seen{0};
  component.on_tick = [&](Time) { seen = sent.load(); };
  Runner sut("test", bus_, component, account_);
  for (int i = 1; i <= 20000; ++i) {
    sent = i;
    component.schedule().input_arrived();
    const Time limit = bus_.now() + patience;
    while (i % 16 == 0 && seen < i) ASSERT_LT(bus_.now(), limit);
  }
}

}  // namespace
}  // namespace tocsin
