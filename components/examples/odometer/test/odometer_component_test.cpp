// SPDX-License-Identifier: Apache-2.0
#include "odometer/odometer_component.hpp"

#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"

namespace example {
namespace {

class OdometerComponentTest : public ::testing::Test {
 protected:
  OdometerComponentTest() { bus_.add(sut_); }
  /// Drives straight on, 50 poses a second.
  void drive(double speed_mps, double s) {
    for (int i = 0; i < static_cast<int>(s * 50); ++i) {
      x_m_ += speed_mps / 50;
      tocsin::topic::Odom::Message pose;
      pose.pose().pose().position().x(x_m_);
      bus_.publish<tocsin::topic::Odom>(pose);
      bus_.run_for(tocsin::seconds(0.02));
    }
  }

  tocsin::SimBus bus_;
  tocsin::Context context_{bus_, "odometer", tocsin::Role::uxv};
  tocsin::SimReader<DistanceDriven> reports_{bus_};
  OdometerComponent sut_{context_, {}};
  double x_m_ = 7;
};

TEST_F(OdometerComponentTest, ReportsOnceASecondHowFarItIs) {
  drive(0.5, 10.5);
  const auto reports = reports_.take();
  EXPECT_NEAR(static_cast<double>(reports.size()), 10.5, 1);
  EXPECT_EQ(reports.front().driven_m(), 0);
  EXPECT_NEAR(reports.back().driven_m(), 5, 0.5);
}

TEST_F(OdometerComponentTest, LosesNoPoseBetweenTwoReports) {
  drive(0.5, 20);
  drive(0, 3);
  EXPECT_NEAR(reports_.take().back().driven_m(), 10, 0.05);
}

TEST_F(OdometerComponentTest, GoesOnToReportWhenPosesStayAway) {
  drive(0.5, 3);
  reports_.take();
  bus_.run_for(tocsin::seconds(10));
  EXPECT_NEAR(static_cast<double>(reports_.take().size()), 10, 1);
}

}  // namespace
}  // namespace example
