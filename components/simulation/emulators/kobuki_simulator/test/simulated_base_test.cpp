// SPDX-License-Identifier: Apache-2.0
#include "simulated_base.hpp"

#include <gtest/gtest.h>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

SimulatedBase make_base() {
  return {BaseModel(ModelParams{}, open_floor(), {}, 1, t0), SerialLine(LineParams{}, 2, t0)};
}

/// Frames that arrive in [from, to], waking exactly when the base asks for it.
std::uint64_t frames(SimulatedBase& sut, Time to) {
  Reassembler reassembler;
  while (sut.next_event() <= to) {
    sut.step(sut.next_event(), [&](ByteView p) { reassembler.feed(p, [](ByteView) {}); });
  }
  return reassembler.counts().frames;
}

TEST(SimulatedBase, DeliversFiftyFramesASecond) {
  SimulatedBase sut = make_base();
  EXPECT_EQ(frames(sut, t0 + seconds(6.01)), 300U);
}

TEST(SimulatedBase, IsSilentForATime) {
  SimulatedBase sut = make_base();
  sut.silence(t0, seconds(1));
  EXPECT_EQ(frames(sut, t0 + seconds(0.99)), 0U);
  EXPECT_EQ(frames(sut, t0 + seconds(2.01)), 51U);
}

TEST(SimulatedBase, LosesBytesBothWaysWhileUnplugged) {
  SimulatedBase sut = make_base();
  sut.unplug(t0, seconds(1));
  EXPECT_FALSE(sut.plugged(t0 + seconds(0.99)));
  sut.receive(encode_command(Tune::on).bytes(), t0 + seconds(0.5));
  EXPECT_EQ(frames(sut, t0 + seconds(0.99)), 0U);
  EXPECT_EQ(sut.model().outputs().sounds, 0U);
  EXPECT_TRUE(sut.plugged(t0 + seconds(1)));
  sut.receive(encode_command(Tune::on).bytes(), t0 + seconds(1));
  EXPECT_EQ(sut.model().outputs().sounds, 1U);
}

TEST(SimulatedBase, StaysUnpluggedUntilPlugged) {
  SimulatedBase sut = make_base();
  sut.unplug(t0, Duration::max());
  EXPECT_FALSE(sut.plugged(t0 + seconds(1e6)));
  sut.plug();
  EXPECT_TRUE(sut.plugged(t0));
}

TEST(SimulatedBase, MovesOnWhileUnplugged) {
  SimulatedBase sut = make_base();
  sut.receive(encode_command(BaseControl{300, 0}).bytes(), t0);
  sut.unplug(t0 + seconds(0.1), seconds(5));
  (void)frames(sut, t0 + seconds(4));
  EXPECT_GT(sut.model().pose().x_m, 1.0);
}

TEST(SimulatedBase, IsSilentASecondAfterAPowerCycle) {
  SimulatedBase sut = make_base();
  sut.power_cycle(t0);
  EXPECT_EQ(frames(sut, t0 + seconds(0.99)), 0U);
  EXPECT_GT(frames(sut, t0 + seconds(1.2)), 5U);
}

}  // namespace
}  // namespace tocsin::kobuki
