// SPDX-License-Identifier: Apache-2.0
// Two queues of one station that are due in the same slot.
#include <gtest/gtest.h>

#include "link_simulation.hpp"

namespace tocsin::radio {
namespace {

/// Video and voice of one station come while it sends a frame, 2000 times.
struct Race {
  double voice_first = 0;   ///< share
  double slots_behind = 0;  ///< mean backoff of video behind a voice frame that was first
};

Race race_video_against_voice() {
  ChannelParams params = place(40, 60);
  params.access_categories = true;
  LinkSimulation link(params);
  (void)link.channel.report(Time{} + seconds(1));  // hears beacons, so the rate is known
  const Duration air =
      frame_duration(7, 100 + mac_overhead_bytes) + sifs + frame_duration(ack_rate(7), ack_bytes);
  constexpr int trials = 2000;
  Race race;
  for (int i = 0; i < trials; ++i) {
    const double at_s = 2 + 0.1 * i;
    link.push(Direction::uplink, 1500, at_s);
    const FrameId video =
        link.push(Direction::uplink, Packet{100, false, AccessCategory::video}, at_s);
    const FrameId voice =
        link.push(Direction::uplink, Packet{100, false, AccessCategory::voice}, at_s);
    link.finish();
    const Duration gap = link.outcomes.at(video).at - link.outcomes.at(voice).at;
    if (gap < Duration::zero()) continue;
    race.voice_first += 1;
    race.slots_behind += to_seconds(gap - air - difs) / to_seconds(slot_time);
  }
  race.slots_behind /= race.voice_first;
  race.voice_first /= trials;
  return race;
}

// Voice draws 0 to 3 slots, video 0 to 7. Of 32 pairs voice is lower in 22, and equal in 4.
TEST(InternalCollision, TheMoreUrgentOneSendsWhenTwoOfAStationAreDueInTheSameSlot) {
  EXPECT_NEAR(race_video_against_voice().voice_first, 26.0 / 32, 0.03);
}

// In the 22 pairs 74 slots are left; in the 4 video draws anew from 0 to 15.
TEST(InternalCollision, TheOtherOneBacksOffAsAfterACollision) {
  EXPECT_NEAR(race_video_against_voice().slots_behind, (74 + 4 * 7.5) / 26, 0.3);
}

}  // namespace
}  // namespace tocsin::radio
