// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/vehicle_stop_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Time t0 = Time{} + seconds(100);
constexpr Duration tick{1};
const VehicleStopView::Report drives{false, {}};
const VehicleStopView::Report stands{true, {"station"}};

class VehicleStopViewTest : public ::testing::Test {
 protected:
  void hear_link(const VehicleStopView::Report& report, Time at) { sut_.on_link(report, 0.05, at); }
  [[nodiscard]] bool says_stands() const { return sut_.report().value().stands; }
  VehicleStopView sut_;
};

TEST_F(VehicleStopViewTest, IsNotHeardAtFirst) { EXPECT_FALSE(sut_.report()); }

TEST_F(VehicleStopViewTest, EitherReportAloneIsEnough) {
  sut_.on_safety_status(stands, t0);
  EXPECT_TRUE(says_stands());
  VehicleStopView other;
  other.on_link(stands, 0, t0);
  EXPECT_TRUE(other.report().value().stands);
  EXPECT_THAT(other.report().value().stopped_by, ElementsAre("station"));
}

TEST_F(VehicleStopViewTest, EitherConfirmsAStopAtOnce) {
  sut_.on_safety_status(drives, t0);
  hear_link(drives, t0);
  hear_link(stands, t0 + seconds(5));
  EXPECT_TRUE(says_stands());
  hear_link(drives, t0 + seconds(10));
  EXPECT_FALSE(says_stands());
  sut_.on_safety_status(stands, t0 + seconds(10));
  EXPECT_TRUE(says_stands());
}

TEST_F(VehicleStopViewTest, AStatusLeftFromAStreamThatEndedYieldsToTheLinkAfterASecond) {
  sut_.on_safety_status(stands, t0);
  hear_link(drives, t0 + VehicleStopView::counts_for - tick);
  EXPECT_TRUE(says_stands());
  hear_link(drives, t0 + VehicleStopView::counts_for);
  EXPECT_FALSE(says_stands());
  EXPECT_THAT(sut_.report()->stopped_by, IsEmpty());
}

TEST_F(VehicleStopViewTest, ALinkThatIsLostYieldsToALaterStatus) {
  hear_link(stands, t0);
  sut_.on_safety_status(drives, t0 + VehicleStopView::counts_for);
  EXPECT_FALSE(says_stands());
}

TEST_F(VehicleStopViewTest, AValueThatIsNotFreshReportsNothing) {
  sut_.on_link(stands, nan, t0);
  sut_.on_link(stands, 1, t0);
  EXPECT_FALSE(sut_.report());
  sut_.on_link(stands, 0.999, t0);
  EXPECT_TRUE(says_stands());
  sut_.on_link(drives, 5, t0 + seconds(9));
  EXPECT_TRUE(says_stands()) << "what was fresh last";
}

TEST_F(VehicleStopViewTest, NamesAllWhoseStopsStandOnce) {
  sut_.on_safety_status({true, {"station", "button (7)"}}, t0);
  hear_link({true, {"station", "gcs"}}, t0);
  EXPECT_THAT(sut_.report()->stopped_by, ElementsAre("station", "gcs", "button (7)"));
}

}  // namespace
}  // namespace tocsin
