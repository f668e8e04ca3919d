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

TEST(Battery, ReadsTheChargerByteAndTakesUndocumentedStatesAsDischarging) {
  struct {
    int charger;
    ChargingState state;
    ChargingSource source;
  } const rows[] = {{0, ChargingState::discharging, ChargingSource::none},
                    {2, ChargingState::charged, ChargingSource::dock},
                    {6, ChargingState::charging, ChargingSource::dock},
                    {18, ChargingState::charged, ChargingSource::adapter},
                    {22, ChargingState::charging, ChargingSource::adapter},
                    {1, ChargingState::discharging, ChargingSource::none},
                    {7, ChargingState::discharging, ChargingSource::none},
                    {0x10, ChargingState::discharging, ChargingSource::none},
                    {0x1F, ChargingState::discharging, ChargingSource::none}};
  for (const auto& [charger, state, source] : rows) {
    const Battery got = sut.read(150, static_cast<std::uint8_t>(charger));
    EXPECT_EQ(got.state, state) << charger;
    EXPECT_EQ(got.source, source) << charger;
  }
}

TEST(Battery, GradesTheLevelOnBothSidesOfEachLimit) {
  EXPECT_EQ(sut.read(132, 0).level, BatteryLevel::dangerous);
  EXPECT_EQ(sut.read(133, 0).level, BatteryLevel::low);
  EXPECT_EQ(sut.read(140, 0).level, BatteryLevel::low);
  EXPECT_EQ(sut.read(141, 0).level, BatteryLevel::healthy);
  EXPECT_EQ(sut.read(141, 18).level, BatteryLevel::maximum);
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
