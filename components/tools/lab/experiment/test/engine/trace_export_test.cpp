// SPDX-License-Identifier: Apache-2.0
#include "engine/trace_export.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::experiment {
namespace {

const double none = std::nan("");

TEST(TraceExport, HasARowForEachMeasurementWithASignal) {
  report::Recording recording;
  recording.qualities = {{99, 0, none, 1}, {100, 0, -50.25, 12.5}, {101.5, 100, -80, none}};
  EXPECT_EQ(trace_text(recording),
            "time_s,rssi_dbm,ping_delay_ms\n0.000,-50.2,12.50\n1.500,-80.0,\n");
}

TEST(TraceExport, RejectsARunWithoutARadio) {
  report::Recording recording;
  recording.qualities = {{100, 0, none, 1}, {101, 0, none, 1}};
  EXPECT_THROW((void)trace_text(recording), ConfigError);
}

}  // namespace
}  // namespace tocsin::experiment
