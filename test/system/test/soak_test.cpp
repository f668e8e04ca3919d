// SPDX-License-Identifier: Apache-2.0
// A slice of mission_soak: each fault once, at processes that carry samples over the link.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>

#include "crossing.hpp"
#include "real_faults.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using Way = Crossings::Way;

TEST(RealFaults, AreEachAsLikelyAndHaveWhatTheyNeed) {
  std::mt19937 random(1);
  std::map<RealFault, int> drawn;
  for (int i = 0; i < 1000; ++i) {
    const PlannedFault planned = draw_fault(random, {"uxv/drive", "gcs/link"});
    ++drawn[planned.fault];
    const bool aims = planned.fault == RealFault::kill || planned.fault == RealFault::freeze;
    EXPECT_EQ(planned.target.empty(), !aims) << to_text(planned);
    EXPECT_LE(planned.time, seconds(12)) << to_text(planned);
  }
  EXPECT_EQ(drawn.size(), 5U);
  for (const auto& one : drawn) EXPECT_GT(one.second, 150);
}

TEST(Soak, SamplesCrossAgainAfterEachFault) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path()), "--seed", "1"}, 64);
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  const Crossings crossings(stack.running("uxv/link"), stack.running("gcs/link"), standing_domain);
  const auto cross_from_now = [&] {
    const std::int64_t now = wall_now_ns();
    return Stack::eventually(seconds(60), [&] {
      return crossings.first_after(Way::up, now) && crossings.first_after(Way::down, now);
    });
  };
  ASSERT_TRUE(cross_from_now()) << stack.output();
  const std::vector<PlannedFault> faults{{RealFault::kill, "gcs/link", {}},
                                         {RealFault::freeze, "uxv/link", seconds(2)},
                                         {RealFault::full_disk, "", seconds(1)},
                                         {RealFault::cpu_hogs, "", seconds(1)},
                                         {RealFault::wlan0, "", seconds(1)}};
  for (const PlannedFault& planned : faults) {
    EXPECT_EQ(inflict(stack, planned), std::nullopt);
    EXPECT_TRUE(cross_from_now()) << "after " << to_text(planned) << "\n" << stack.output();
  }
}

}  // namespace
}  // namespace tocsin
