// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "runtime/middleware/gate_component.hpp"
#include "runtime/middleware/gate_keeper.hpp"
#include "runtime/middleware/gated_writer.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using String = std_msgs::msg::String;

/// Notes what reaches the middleware.
class Recorder : public LinkWriter {
 public:
  explicit Recorder(std::vector<std::string>& log) : log_(log) {}
  std::size_t send(const void* message) override {
    if (refuse) return 0;
    log_.push_back(static_cast<const String*>(message)->data());
    return 10;
  }
  void silence() override { log_.emplace_back("(silence)"); }
  bool refuse = false;

 private:
  std::vector<std::string>& log_;
};

class GateTest : public ::testing::Test {
 protected:
  GatedWriter make(WhilePoor while_poor) {
    auto writer = std::make_unique<Recorder>(log_);
    recorder_ = writer.get();
    return {"topic",
            {TrafficClass::low, while_poor},
            std::move(writer),
            {[this] { return now_; }, lifespan}};
  }
  static constexpr Duration lifespan = std::chrono::seconds(5);
  static std::shared_ptr<const String> text(const std::string& data) {
    auto message = std::make_shared<String>();
    message->data(data);
    return message;
  }
  Time now_{};
  std::vector<std::string> log_;
  Recorder* recorder_ = nullptr;
};

TEST_F(GateTest, OpenGateSendsAndCounts) {
  GatedWriter sut = make(WhilePoor::drop);
  EXPECT_EQ(sut.write(text("a")), Status::ok);
  EXPECT_EQ(log_, std::vector<std::string>{"a"});
  EXPECT_EQ(sut.traffic().sent, 1U);
  EXPECT_EQ(sut.traffic().sent_bytes, 10U);
}

TEST_F(GateTest, WithoutALinkEvenAnAlwaysActiveTopicKeepsItsNewestAndSendsItOnceConnected) {
  GatedWriter sut("topic", {TrafficClass::critical, WhilePoor::send}, nullptr, {});
  EXPECT_EQ(sut.write(text("old")), Status::paused);
  EXPECT_EQ(sut.write(text("new")), Status::paused);
  EXPECT_TRUE(sut.traffic().paused);
  sut.connect(std::make_unique<Recorder>(log_));
  EXPECT_EQ(log_, std::vector<std::string>{"new"});
  EXPECT_FALSE(sut.traffic().paused);
  EXPECT_EQ(sut.write(text("next")), Status::ok);
}

TEST_F(GateTest, ConnectedWhileItIsClosedItStaysSilentUntilItOpens) {
  GatedWriter sut("topic", {TrafficClass::low, WhilePoor::latest}, nullptr, {});
  sut.set_open(false);
  EXPECT_EQ(sut.write(text("kept")), Status::paused);
  sut.connect(std::make_unique<Recorder>(log_));
  EXPECT_TRUE(log_.empty());
  sut.set_open(true);
  EXPECT_EQ(log_, std::vector<std::string>{"kept"});
}

/// Counts; not thread-safe, like a writer that relies on the gate's turns.
class Counter : public LinkWriter {
 public:
  explicit Counter(std::uint64_t& sent) : sent_(sent) {}
  std::size_t send(const void*) override { return ++sent_ > 0 ? 1 : 0; }
  void silence() override {}

 private:
  std::uint64_t& sent_;
};

TEST_F(GateTest, AClosedGateIsSilentHoweverManyThreadsFloodIt) {
  std::uint64_t sent = 0;
  GatedWriter sut("topic", {TrafficClass::low, WhilePoor::drop}, std::make_unique<Counter>(sent),
                  {});
  std::atomic<bool> stop{false};
  std::vector<std::thread> floods;
  for (int i = 0; i < 3; ++i) {
    floods.emplace_back([&] {
      while (!stop) (void)sut.write(nullptr);
    });
  }
  for (int round = 0; round < 100; ++round) {
    sut.set_open(false);
    const std::uint64_t silent = sut.traffic().sent;
    std::this_thread::yield();
    EXPECT_EQ(sut.traffic().sent, silent);
    EXPECT_EQ(sent, silent);  // read without the turn: nobody may be sending
    sut.set_open(true);
  }
  stop = true;
  for (std::thread& flood : floods) flood.join();
  const TopicTraffic traffic = sut.traffic();
  EXPECT_EQ(traffic.written, traffic.sent + traffic.dropped);
  EXPECT_EQ(traffic.sent, sent);
}

TEST_F(GateTest, ClosedGateSilencesTheWriterAndDrops) {
  GatedWriter sut = make(WhilePoor::drop);
  sut.set_open(false);
  EXPECT_EQ(sut.write(text("a")), Status::paused);
  sut.set_open(true);
  EXPECT_EQ(log_, std::vector<std::string>{"(silence)"});
  EXPECT_EQ(sut.traffic().dropped, 1U);
  EXPECT_EQ(sut.traffic().written, 1U);
  EXPECT_EQ(sut.traffic().sent, 0U);
}

TEST_F(GateTest, LatestSendsOnlyTheNewestOnResume) {
  GatedWriter sut = make(WhilePoor::latest);
  sut.set_open(false);
  EXPECT_EQ(sut.write(text("a")), Status::paused);
  EXPECT_EQ(sut.write(text("b")), Status::paused);
  sut.set_open(true);
  EXPECT_EQ(log_, (std::vector<std::string>{"(silence)", "b"}));
  EXPECT_EQ(sut.traffic().held, 1U);
}

TEST_F(GateTest, AKeptSampleIsSentUpToItsLifespanAndThenDropped) {
  for (const bool late : {false, true}) {
    GatedWriter sut = make(WhilePoor::latest);
    log_.clear();
    sut.set_open(false);
    EXPECT_EQ(sut.write(text("a")), Status::paused);
    now_ += lifespan + std::chrono::nanoseconds(late ? 1 : 0);
    sut.set_open(true);
    EXPECT_EQ(log_.size(), late ? 1U : 2U);
    EXPECT_EQ(sut.traffic().dropped, late ? 1U : 0U);
  }
}

TEST_F(GateTest, LatestSendsNothingOnResumeWhenNothingWasWritten) {
  GatedWriter sut = make(WhilePoor::latest);
  sut.set_open(false);
  sut.set_open(true);
  EXPECT_EQ(log_, std::vector<std::string>{"(silence)"});
}

TEST_F(GateTest, ACriticalTopicIgnoresTheGate) {
  GatedWriter sut = make(WhilePoor::send);
  sut.set_open(false);
  EXPECT_EQ(sut.write(text("a")), Status::ok);
  EXPECT_EQ(log_, std::vector<std::string>{"a"});
  EXPECT_FALSE(sut.traffic().paused);
}

TEST_F(GateTest, ClosingTwiceSilencesOnce) {
  GatedWriter sut = make(WhilePoor::drop);
  sut.set_open(false);
  sut.set_open(false);
  EXPECT_EQ(log_.size(), 1U);
  EXPECT_TRUE(sut.traffic().paused);
}

TEST_F(GateTest, ARefusedSampleIsReportedAndNotCountedAsSent) {
  GatedWriter sut = make(WhilePoor::drop);
  recorder_->refuse = true;
  EXPECT_EQ(sut.write(text("a")), Status::failed);
  EXPECT_EQ(sut.traffic().written, 1U);
  EXPECT_EQ(sut.traffic().sent, 0U);
}

const Time t0{std::chrono::hours(1)};

TEST(GateKeeper, IsOpenBeforeAnyState) {
  EXPECT_TRUE(GateKeeper(seconds(5)).open(t0));
  EXPECT_EQ(GateKeeper(seconds(5)).deadline(t0), never);
}

TEST(GateKeeper, FollowsTheState) {
  GateKeeper sut(seconds(5));
  sut.on_state(false, t0);
  EXPECT_FALSE(sut.open(t0));
  sut.on_state(true, t0 + seconds(1));
  EXPECT_TRUE(sut.open(t0 + seconds(1)));
}

TEST(GateKeeper, OpensOnlyAfterSilenceLongerThanTheLimit) {
  GateKeeper sut(seconds(5));
  sut.on_state(false, t0);
  EXPECT_FALSE(sut.open(t0 + seconds(5)));
  const Time deadline = sut.deadline(t0 + seconds(5));
  EXPECT_TRUE(sut.open(deadline));
  EXPECT_EQ(sut.deadline(deadline), never);
}

class GateComponentTest : public ::testing::Test {
 protected:
  static tocsin_msgs::msg::TransmissionState state(const std::string& role, bool active) {
    tocsin_msgs::msg::TransmissionState message;
    message.role(role);
    message.active(active);
    return message;
  }
  SimBus bus_;
  Context context_{bus_, "gate", "uxv", ""};
  GateComponent sut_{context_, {}, "process"};
};

TEST_F(GateComponentTest, ClosesTheBusWhenItsRoleIsPassive) {
  bus_.add(sut_);
  bus_.publish<topic::TransmissionState>(state("uxv", false));
  bus_.run_for(seconds(0.1));
  EXPECT_FALSE(bus_.gate_open());
}

TEST_F(GateComponentTest, IgnoresTheOtherRole) {
  bus_.add(sut_);
  bus_.publish<topic::TransmissionState>(state("gcs", false));
  bus_.run_for(seconds(0.1));
  EXPECT_TRUE(bus_.gate_open());
}

TEST_F(GateComponentTest, OpensWhenTheControllerDies) {
  bus_.add(sut_);
  bus_.publish<topic::TransmissionState>(state("uxv", false));
  bus_.run_for(seconds(5));
  EXPECT_FALSE(bus_.gate_open());
  bus_.run_for(seconds(0.1));
  EXPECT_TRUE(bus_.gate_open());
}

}  // namespace
}  // namespace tocsin
