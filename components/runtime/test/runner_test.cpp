// SPDX-License-Identifier: Apache-2.0
#include "../src/runner.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <stdexcept>

namespace tocsin {
namespace {

/// Real time, no topics.
class ClockBus : public Bus {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint&, Receiver&) override { return nullptr; }
  std::unique_ptr<Publication> advertise(const Endpoint&) override { return nullptr; }
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
  [[nodiscard]] std::int64_t wall_ns(Time) const override { return 0; }
  void set_gate(bool) override {}
  [[nodiscard]] std::vector<TopicTraffic> link_traffic() const override { return {}; }
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
  ClockBus bus_;
  Context context_{bus_, "counting", "uxv", ""};
};

TEST_F(RunnerTest, TicksOnceAtStartThenOnInput) {
  Counting component(context_);
  Runner sut("test", bus_);
  sut.add(component);
  sut.start();
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
    Runner sut("test", bus_);
    sut.add(component);
    sut.start();
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
    Runner sut("test", bus_);
    sut.add(component);
    sut.start();
    ASSERT_TRUE(component.wait_for_ticks(1));
    ASSERT_EQ(write(ends[1], "x", 1), 1);
    EXPECT_TRUE(component.wait_for_ticks(2));
  }  // the tick that reads has ended
  close(ends[0]);
  close(ends[1]);
}

TEST_F(RunnerTest, AThrowingComponentDiesAloneAndItsNeighbourGoesOn) {
  Counting bad(context_);
  Counting good(context_);
  bad.on_tick = [](Time) { throw std::runtime_error("broken"); };
  Runner sut("test", bus_);
  sut.add(bad);
  sut.add(good);
  sut.start();
  ASSERT_TRUE(good.wait_for_ticks(1));
  bad.schedule().input_arrived();
  good.schedule().input_arrived();
  EXPECT_TRUE(good.wait_for_ticks(2));
  EXPECT_EQ(bad.ticks(), 1);
}

}  // namespace
}  // namespace tocsin
