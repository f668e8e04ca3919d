// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/battery.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

const BatteryReader sut{BatteryParams{}};

TEST(Battery, HasTheReferencePercentages) {
  const struct {
    std::uint8_t dv;
    double percent;
  } rows[]{{132, 5.00},  {133, 7.88}, {140, 28.03}, {150, 56.82}, {158, 79.85},
           {164, 97.12}, {165, 100},  {170, 100},   {100, 0}};
  for (const auto& row : rows) {
    EXPECT_NEAR(sut.read(row.dv, 0).percentage, row.percent / 100, 5e-5) << int{row.dv};
    EXPECT_NEAR(sut.read(row.dv, 6).percentage, row.percent / 100, 5e-5) << int{row.dv};
  }
}

TEST(Battery, KeepsOneFormulaWhenCharged) {
  // The reference driver lowers its capacity for good here and then says 100 % at 15.8 V.
  EXPECT_NEAR(sut.read(132, 2).percentage, 0.05, 1e-9);
  EXPECT_NEAR(sut.read(158, 18).percentage, 0.7985, 5e-5);
  EXPECT_NEAR(sut.read(158, 0).percentage, 0.7985, 5e-5);
}

TEST(Battery, GradesTheLevelOnBothSidesOfEachLimit) {
  EXPECT_EQ(sut.read(132, 0).level, BatteryLevel::dangerous);
  EXPECT_EQ(sut.read(133, 0).level, BatteryLevel::low);
  EXPECT_EQ(sut.read(140, 0).level, BatteryLevel::low);
  EXPECT_EQ(sut.read(141, 0).level, BatteryLevel::healthy);
  EXPECT_EQ(sut.read(141, 18).level, BatteryLevel::maximum);
}

TEST(Battery, ReadsTheChargerByte) {
  EXPECT_EQ(sut.read(150, 0).state, ChargingState::discharging);
  EXPECT_EQ(sut.read(150, 2).state, ChargingState::charged);
  EXPECT_EQ(sut.read(150, 2).source, ChargingSource::dock);
  EXPECT_EQ(sut.read(150, 6).state, ChargingState::charging);
  EXPECT_EQ(sut.read(150, 18).source, ChargingSource::adapter);
  EXPECT_EQ(sut.read(150, 22).state, ChargingState::charging);
  EXPECT_EQ(sut.read(150, 22).source, ChargingSource::adapter);
}

TEST(Battery, TakesUndocumentedStatesAsDischarging) {
  for (const int charger : {1, 3, 4, 5, 7, 15, 0x10, 0x1F}) {
    const Battery got = sut.read(150, static_cast<std::uint8_t>(charger));
    EXPECT_EQ(got.state, ChargingState::discharging) << charger;
    EXPECT_EQ(got.source, ChargingSource::none) << charger;
  }
}

TEST(Battery, RefusesLimitsOutOfOrder) {
  BatteryParams params;
  params.low_v = 13.2;
  EXPECT_THROW(BatteryReader{params}, ConfigError);
  params = {};
  params.capacity_v = 14.0;
  EXPECT_THROW(BatteryReader{params}, ConfigError);
}

}  // namespace
}  // namespace tocsin::kobuki
