// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "view_state.hpp"

namespace tocsin {
namespace {

TEST(SummaryLine, IsOneLine) {
  EXPECT_EQ(summary_line(full_state(), t0, limits),
            "waypoint 4/9 running  at (1.23, 0.00) m  QNI 50.0  vehicle passive (cusum_alarm)  "
            "station active (cusum_alarm)");
}

TEST(SummaryLine, TellsAgesAndWhatHindersTheVehicle) {
  ViewState state = full_state();
  state.safety->value.emergency_stop(true);
  state.location->at = t0 - seconds(40);
  state.uxv->at = t0 - seconds(5);
  EXPECT_EQ(summary_line(state, t0, limits),
            "EMERGENCY STOP  waypoint 4/9 running  location unknown for 40 s  "
            "QNI 50.0  vehicle passive (cusum_alarm) 5 s ago  station active (cusum_alarm)");
}

}  // namespace
}  // namespace tocsin
