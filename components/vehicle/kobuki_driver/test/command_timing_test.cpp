// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>

#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {
namespace {

/// A driver that is given frames by hand: counts the bursts of commands.
struct ByHand {
  ByHand() { driver.on_port_open(); }
  void frame() {
    Feedback feedback;
    feedback.core = CoreSensors{};
    const Frame bytes = encode_feedback(feedback);
    driver.on_bytes(bytes.bytes(), now, [](const Reading&) {});
  }
  int run() {
    int writes = 0;
    driver.run(now, [&](ByteView) { ++writes; });
    return writes;
  }
  void pass(int ms) { now += std::chrono::milliseconds(ms); }
  Time now = Time{} + seconds(10);
  KobukiDriver driver{KobukiDriver::Params{}};
};

TEST(CommandTiming, AnswersEachFrameAtOnce) {
  ByHand sut;
  for (int i = 0; i < 50; ++i) {
    sut.frame();
    EXPECT_GE(sut.run(), 1) << i;
    EXPECT_EQ(sut.run(), 0) << i;
    sut.pass(20);
    EXPECT_EQ(sut.run(), 0) << i;
  }
}

TEST(CommandTiming, CommandsAfterThirtyMillisecondsWhenAFrameIsLate) {
  ByHand sut;
  sut.frame();
  EXPECT_GE(sut.run(), 1);
  sut.pass(29);
  EXPECT_EQ(sut.run(), 0);
  EXPECT_EQ(sut.driver.next_deadline(), sut.now + std::chrono::milliseconds(1));
  sut.pass(1);
  EXPECT_GE(sut.run(), 1);
}

TEST(CommandTiming, TwoFramesInOneReadAreOneCommand) {
  ByHand sut;
  sut.frame();
  EXPECT_GE(sut.run(), 1);
  sut.pass(9);
  sut.frame();
  EXPECT_EQ(sut.run(), 0);
  sut.pass(1);
  sut.frame();
  EXPECT_GE(sut.run(), 1);
}

}  // namespace
}  // namespace tocsin::kobuki
