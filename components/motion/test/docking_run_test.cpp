// SPDX-License-Identifier: Apache-2.0
/// Docking with the model of the base and the dock's light, in virtual time.
#include <gtest/gtest.h>

#include <cmath>

#include "kobuki_model/base_model.hpp"
#include "motion/auto_docking.hpp"

namespace tocsin::motion {
namespace {

using namespace kobuki;  // NOLINT: every name of the model is used here

const Time t0 = Time{} + seconds(100);

struct DockingRunEnd {
  DockingResult result;
  double duration_s;
  ChargingSource source;
};

DockingRunEnd dock_from(const Pose& start, std::uint64_t seed) {
  const Dock dock({0, 0, 0});
  BaseModel model(ModelParams{}, walled({dock.front(), {-0.05, -5, -0.05, 5, 0}}), start, seed, t0);
  model.set_dock(dock);
  Odometry odometry{OdometryParams{}};
  AutoDocking docking{AutoDocking::Params{}};
  docking.start(t0);
  Time now = t0;
  while (docking.running()) {
    now += std::chrono::milliseconds(20);
    model.step(now, [&](Time at, ByteView frame) {
      DecodeCounts counts;
      const Feedback got = decode_feedback(frame.part(3, frame.size - 4), counts);
      odometry.update(*got.core, got.inertia);
      const BodyVelocity wanted = docking.update(
          {*got.dock_infrared, got.core->bumper, got.core->charger, odometry.pose().heading_rad},
          at);
      model.receive(encode_command(encode_velocity(wanted)).bytes(), at);
    });
  }
  return {docking.result(), to_seconds(now - t0), model.power().source()};
}

TEST(DockingRun, ArrivesFromEveryPartOfTheField) {
  for (const double x_m : {0.6, 1.2, 2.0}) {
    for (const double angle_deg : {0.0, 20.0, -20.0, 40.0, -40.0}) {
      for (const double yaw : {0.0, 2.0, -2.5}) {
        const double y_m = x_m * std::tan(angle_deg * degree_rad);
        const DockingRunEnd run = dock_from({x_m, y_m, yaw}, 3);
        EXPECT_EQ(run.result, DockingResult::docked)
            << to_string(run.result) << " from " << x_m << " " << y_m << " " << yaw;
        EXPECT_EQ(run.source, ChargingSource::dock);
      }
    }
  }
}

TEST(DockingRun, EndsOutsideTheField) {
  const DockingRunEnd run = dock_from({6, 0, 0}, 3);
  EXPECT_EQ(run.result, DockingResult::no_dock_found);
  EXPECT_NEAR(run.duration_s, 40, 0.2);
}

}  // namespace
}  // namespace tocsin::motion
