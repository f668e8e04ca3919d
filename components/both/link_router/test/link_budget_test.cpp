// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_budget.hpp"

#include <gtest/gtest.h>

#include "link_router/link_constants.hpp"

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration step = std::chrono::milliseconds(50);

class AdaptiveScaleTest : public ::testing::Test {
 protected:
  /// The scale after `length` of this.
  double run(const AdaptiveScale::Input& input, Duration length) {
    for (const Time end = now + length; now < end; now += step) sut.update(input, now);
    return sut.scale();
  }
  LinkRouterParams params;
  AdaptiveScale sut{params};
  Time now = t0;
};

AdaptiveScale::Input input(double capacity_bytes_per_s, double nominal_bytes_per_s) {
  AdaptiveScale::Input in;
  in.capacity_bytes_per_s = capacity_bytes_per_s;
  in.nominal_bytes_per_s = nominal_bytes_per_s;
  return in;
}

TEST_F(AdaptiveScaleTest, IsOneWhileThereIsRoom) {
  EXPECT_EQ(run(input(1e6, 300e3), std::chrono::seconds(10)), 1);
  EXPECT_EQ(run(input(1e6, 0), std::chrono::seconds(10)), 1) << "nothing adapts";
}

TEST_F(AdaptiveScaleTest, ComesToTheShareOfTheCapacityThatIsLeft) {
  AdaptiveScale::Input in = input(400e3, 300e3);
  in.others_bytes_per_s = 20e3;
  const double wanted = (utilisation * 400e3 - 20e3) / 300e3;
  EXPECT_NEAR(run(in, std::chrono::seconds(20)), wanted, scale_step);
}

TEST_F(AdaptiveScaleTest, FallsFasterThanItRises) {
  const double low = run(input(10e3, 300e3), std::chrono::seconds(2));
  EXPECT_LT(low, 0.35);
  EXPECT_LT(run(input(1e6, 300e3), std::chrono::seconds(2)), 0.75);
  EXPECT_EQ(run(input(1e6, 300e3), std::chrono::seconds(40)), 1);
}

TEST_F(AdaptiveScaleTest, DoesNotTellNoise) {
  (void)run(input(300e3, 300e3), std::chrono::seconds(30));
  int changes = 0;
  double before = sut.scale();
  for (int i = 0; i < 400; ++i, now += step) {
    sut.update(input(i % 2 == 0 ? 315e3 : 285e3, 300e3), now);
    changes += sut.scale() != before ? 1 : 0;
    before = sut.scale();
  }
  EXPECT_LE(changes, 1);
}

TEST(RateMeter, ComesToTheRateAndForgets) {
  RateMeter sut;
  Time now = t0;
  for (int i = 0; i < 200; ++i, now += std::chrono::milliseconds(100)) sut.add(1000, now);
  EXPECT_NEAR(sut.bytes_per_s(now), 10000, 600);
  EXPECT_LT(sut.bytes_per_s(now + std::chrono::seconds(20)), 10);
}

}  // namespace
}  // namespace tocsin::router
