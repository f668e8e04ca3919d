// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
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
    return {"topic", {"low", while_poor}, std::move(writer), {[this] { return now_; }, lifespan}};
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
