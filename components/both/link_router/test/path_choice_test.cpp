// SPDX-License-Identifier: Apache-2.0
#include "link_router/path_choice.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr PathHealth good{false, true, 0, 5 * ms};
constexpr PathHealth slow{false, true, 0, 60 * ms};
constexpr PathHealth lossy{false, true, 0.3, 5 * ms};
constexpr PathHealth silent{true, true, 1, 5 * ms};

TEST(PathChoice, BeginsWithTheFirstAndStaysWhileItIsNoWorse) {
  PathChoice sut;
  for (int s = 0; s < 10; ++s) sut.update({good, good}, t0 + s * 1000 * ms);
  EXPECT_EQ(sut.chosen(), 0);
}

TEST(PathChoice, LeavesASilentPathAtOnceUnlessTheOtherIsSilentToo) {
  PathChoice sut;
  sut.update({silent, silent}, t0);
  EXPECT_EQ(sut.chosen(), 0);
  sut.update({silent, lossy}, t0);
  EXPECT_EQ(sut.chosen(), 1);
}

TEST(PathChoice, LeavesAWorsePathAfterThreeSecondsInARow) {
  for (const PathHealth& worse : {slow, lossy}) {
    PathChoice sut;
    sut.update({worse, good}, t0);
    sut.update({worse, good}, t0 + 2900 * ms);
    EXPECT_EQ(sut.chosen(), 0);
    sut.update({good, good}, t0 + 2950 * ms);
    sut.update({worse, good}, t0 + 3000 * ms);
    sut.update({worse, good}, t0 + 5900 * ms);
    EXPECT_EQ(sut.chosen(), 0) << "it was good in between";
    sut.update({worse, good}, t0 + 6000 * ms);
    EXPECT_EQ(sut.chosen(), 1);
  }
}

TEST(PathChoice, DoesNotLeaveAPathForOneThatIsNotKnown) {
  PathChoice sut;
  PathHealth unknown;
  for (int s = 0; s < 10; ++s) sut.update({slow, unknown}, t0 + s * 1000 * ms);
  EXPECT_EQ(sut.chosen(), 0);
  sut.update({silent, unknown}, t0 + 10000 * ms);
  EXPECT_EQ(sut.chosen(), 1) << "but for none";
}

}  // namespace
}  // namespace tocsin::router
