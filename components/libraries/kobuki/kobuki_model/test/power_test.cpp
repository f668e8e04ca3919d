// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/power.hpp"

#include <gtest/gtest.h>

namespace tocsin::kobuki {
namespace {

TEST(Power, DrainsWithTheLoad) {
  ModelParams params;
  params.battery_charge = 1;
  Power idle{params};
  Power driving{params};
  for (int i = 0; i < 3600; ++i) {
    idle.step(1, 0);
    driving.step(1, 1);
  }
  EXPECT_NEAR(idle.charge(), 1 - 0.5 / 2.2, 1e-9);  // 0.5 A for an hour
  EXPECT_NEAR(driving.charge(), 1 - 1.5 / 2.2, 1e-9);
  EXPECT_LT(driving.battery_dv(), idle.battery_dv());
  params.battery_drain_scale = 100;
  Power scaled{params};
  scaled.step(36, 0);
  EXPECT_NEAR(scaled.charge(), 1 - 0.5 / 2.2, 1e-9);
}

TEST(Power, NeverLeavesItsRange) {
  Power sut{ModelParams{}};
  sut.set_charge(1);
  EXPECT_EQ(sut.battery_dv(), 166);
  sut.set_charge(0);
  EXPECT_EQ(sut.battery_dv(), 130);
  sut.set_charge(0.0001);
  sut.step(3600, 2);
  EXPECT_EQ(sut.charge(), 0);
  sut.plug(ChargingSource::adapter);
  sut.step(36000, 0);
  EXPECT_EQ(sut.charge(), 1);
}

TEST(Power, ReportsTheChargerAsTheWireDoes) {
  Power sut{ModelParams{}};
  sut.step(1, 0);
  EXPECT_EQ(sut.charger(), 0);
  sut.plug(ChargingSource::dock);
  EXPECT_EQ(sut.charger(), 6);
  sut.plug(ChargingSource::adapter);
  EXPECT_EQ(sut.charger(), 22);
  sut.set_charge(1);
  EXPECT_EQ(sut.charger(), 18);
  sut.plug(ChargingSource::dock);
  EXPECT_EQ(sut.charger(), 2);
}

}  // namespace
}  // namespace tocsin::kobuki
