// SPDX-License-Identifier: Apache-2.0
#include "watch/activity.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tocsin {
namespace {

bool is_watched(const Activity& wanted) {
  const auto all = watched_activities();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.get() == &wanted; });
}

TEST(Activity, ATurnBeginsAndEnds) {
  Activity activity(Duty::reception, "reception", 7411);
  {
    const ActivityTurn turn(activity);
    EXPECT_EQ(activity.begun(), 1U);
    EXPECT_EQ(activity.ended(), 0U);
  }
  EXPECT_EQ(activity.ended(), 1U);
}

TEST(WatchedActivities, AreThoseThatSomebodyHolds) {
  auto kept = watched_activity(Duty::reception, "kept", 1);
  auto dropped = watched_activity(Duty::announcements, "dropped");
  EXPECT_TRUE(is_watched(*kept));
  EXPECT_TRUE(is_watched(*dropped));
  const Activity* const gone = dropped.get();
  dropped.reset();
  EXPECT_FALSE(is_watched(*gone));
  EXPECT_TRUE(is_watched(*kept));
}

}  // namespace
}  // namespace tocsin
