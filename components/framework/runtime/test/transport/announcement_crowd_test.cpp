// SPDX-License-Identifier: Apache-2.0
#include "transport/announcement_crowd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace tocsin {
namespace {

using namespace std::chrono_literals;

class AnnouncementCrowdTest : public ::testing::Test {
 protected:
  /// The longest pause of so many participants within `length`.
  Duration hear(int participants, Duration length) {
    Duration longest{0};
    const Time end = now_ + length;
    while (now_ < end) {
      now_ += 500ms;
      for (int i = 0; i < participants; ++i) {
        longest = std::max(longest, sut_.on_announcement(now_));
      }
    }
    return longest;
  }
  Time now_{1000s};
  AnnouncementCrowd sut_;
};

TEST_F(AnnouncementCrowdTest, AFewAreHeardAtOnce) { EXPECT_EQ(hear(20, 60s), 0s); }

TEST_F(AnnouncementCrowdTest, ManyAreHeardTogether) {
  (void)hear(40, 10s);
  EXPECT_EQ(hear(40, 500ms), AnnouncementCrowd::pause);
}

TEST_F(AnnouncementCrowdTest, WhoBeginsHearsEachAtOnce) { EXPECT_EQ(hear(40, 5s), 0s); }

TEST_F(AnnouncementCrowdTest, ACrowdThatLeavesIsNoneAnyMore) {
  (void)hear(40, 20s);
  (void)hear(2, 10s);
  EXPECT_EQ(hear(2, 20s), 0s);
}

TEST_F(AnnouncementCrowdTest, AfterASilenceEachIsHeardAtOnce) {
  (void)hear(40, 20s);
  now_ += 60s;
  EXPECT_EQ(hear(40, 4s), 0s);
}

}  // namespace
}  // namespace tocsin
