// SPDX-License-Identifier: Apache-2.0
#include "teleop/teleop_sender.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);

TEST(TeleopSender, IsSilentUntilSomethingIsHeld) {
  TeleopSender sut{TeleopSender::Params{}};
  EXPECT_FALSE(sut.update(t0));
  EXPECT_EQ(sut.next_deadline(), never);
  sut.hold({});
  EXPECT_FALSE(sut.update(t0));
}

TEST(TeleopSender, SendsAChangeAtOnceAndRepeatsIt) {
  TeleopSender sut{TeleopSender::Params{}};
  sut.hold({0.3, 0});
  EXPECT_EQ(sut.update(t0)->linear_mps, 0.3);
  EXPECT_FALSE(sut.update(t0 + seconds(0.099)));
  EXPECT_EQ(sut.update(t0 + seconds(0.1))->linear_mps, 0.3);
  sut.hold({0.3, 0.5});
  EXPECT_EQ(sut.update(t0 + seconds(0.11))->angular_rad_s, 0.5);
}

TEST(TeleopSender, SendsZeroThreeTimesAtReleaseAndThenNothing) {
  TeleopSender sut{TeleopSender::Params{}};
  sut.hold({0.3, 0});
  ASSERT_TRUE(sut.update(t0));
  sut.hold({});
  for (int i = 0; i < TeleopSender::zeros; ++i) {
    const auto out = sut.update(t0 + seconds(0.1 * i + 0.05));
    ASSERT_TRUE(out) << i;
    EXPECT_EQ(out->linear_mps, 0);
  }
  EXPECT_FALSE(sut.update(t0 + seconds(10)));
  EXPECT_EQ(sut.next_deadline(), never);
}

TEST(TeleopSender, AsksToBeCalledAtItsRateWhileItDrives) {
  TeleopSender::Params params;
  params.rate_hz = 20;
  TeleopSender sut{params};
  EXPECT_EQ(sut.next_deadline(), never);
  sut.hold({0.3, 0});
  ASSERT_TRUE(sut.update(t0));
  EXPECT_EQ(sut.next_deadline(), t0 + seconds(0.05));
}

}  // namespace
}  // namespace tocsin
