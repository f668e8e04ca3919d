// SPDX-License-Identifier: Apache-2.0
// A vehicle with two sites, one after the other: real processes, real DDS, an emulated radio.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string>

#include "emergency_stop_rig.hpp"
#include "site_rig.hpp"

namespace tocsin {
namespace {

TEST(TwoSites, WhenTheRouterOfOneIsFrozenOrKilledTheOtherGoesOnWithinASecond) {
  SiteRig sut;
  ASSERT_TRUE(sut.runs()) << sut.stack().output();
  for (const auto trouble : {SiteRig::Trouble::freeze, SiteRig::Trouble::kill}) {
    const auto silence = sut.hand_over(trouble);
    ASSERT_TRUE(silence) << sut.stack().output();
    EXPECT_LT(silence->up_s, 1.0);
    EXPECT_LT(silence->down_s, 1.0);
    EXPECT_LT(silence->back_up_s, 1.0);
    EXPECT_LT(silence->back_down_s, 1.0);
  }
  const std::int64_t end_ns = wall_now_ns();
  EXPECT_TRUE(
      Stack::eventually(std::chrono::seconds(60), [&] { return sut.stored(end_ns).missing == 0; }));
  const SiteRig::Stored stored = sut.stored(end_ns);
  EXPECT_GT(stored.logged, 40U);
  EXPECT_EQ(stored.twice, 0U);
}

/// The main job with both sites.
class SitesMissionTest : public EmergencyStopTest {
 protected:
  SitesMissionTest() { bringup_ = "two_sites.yaml"; }
};

TEST_F(SitesMissionTest, TheMissionGoesOnAndTheOtherSiteStopsTheVehicle) {
  drive();
  const pid_t router = stack_->running("gcs/link");
  kill(router, SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_TRUE(moves()) << "the mission goes on at the other site";
  const std::vector<std::string> at_south{"--run-dir", stack_->folder(), "--host", "south"};
  const auto say = [&](const char* order) {
    std::vector<std::string> words{order};
    words.insert(words.end(), at_south.begin(), at_south.end());
    return estop(words);
  };
  EXPECT_EQ(say("on"), 0) << said();
  EXPECT_TRUE(stands());
  EXPECT_EQ(say("off"), 0) << said();
  EXPECT_TRUE(moves());
  EXPECT_TRUE(stack_->logged("south is the site from now on")) << stack_->output();
  kill(router, SIGCONT);
  EXPECT_TRUE(Stack::eventually(std::chrono::seconds(20),
                                [&] { return stack_->logged("gcs is the site from now on"); }));
  EXPECT_TRUE(moves());
}

}  // namespace
}  // namespace tocsin
