// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/diagnostics.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

Diagnosis find(const std::vector<Diagnosis>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Diagnosis& d) { return d.name == name; });
  return found == all.end() ? Diagnosis{Health::stale, "absent", {}, {}} : *found;
}

std::string value(const Diagnosis& diagnosis, const std::string& key) {
  for (const auto& [name, text] : diagnosis.values) {
    if (name == key) return text;
  }
  return "absent";
}

struct Diagnostics : ::testing::Test {
  Diagnosis of(const char* name) {
    rig.run(0.1);
    return find(diagnose(rig.driver, &rig.last), name);
  }
  ModelRig rig;
};

TEST_F(Diagnostics, HasTheTenTasksOfTheReferenceAndTheSerialLine) {
  for (const char* name :
       {"Battery", "Watchdog", "Cliff Sensor", "Wall Sensor", "Wheel Drop", "Motor Current",
        "Motor State", "Gyro Sensor", "Digital Input", "Analog Input", "Serial Line"}) {
    EXPECT_EQ(of(name).level, Health::ok) << name;
  }
}

TEST_F(Diagnostics, LabelsSensorsBySideAndNumber) {
  rig.model.inputs().cliff = left_bit;
  rig.model.inputs().digital = 1;
  const Diagnosis cliff = of("Cliff Sensor");
  EXPECT_EQ(cliff.level, Health::warn);
  EXPECT_EQ(value(cliff, "left"), "yes");
  EXPECT_EQ(value(cliff, "right"), "no");
  EXPECT_EQ(value(cliff, "left_adc"), "300");
  EXPECT_EQ(value(cliff, "right_adc"), "1800");
  const Diagnosis input = of("Digital Input");
  EXPECT_EQ(value(input, "DI0"), "yes");
  EXPECT_EQ(value(input, "DI3"), "no");
}

TEST_F(Diagnostics, WarnsOfBumperWheelDropAndOverCurrent) {
  rig.model.inputs().bumper = centre_bit;
  rig.model.inputs().wheel_drop = left_wheel_drop_bit;
  rig.model.inputs().over_current = left_over_current_bit;
  EXPECT_EQ(of("Wall Sensor").level, Health::warn);
  EXPECT_EQ(value(of("Wheel Drop"), "left"), "yes");
  EXPECT_EQ(value(of("Wheel Drop"), "right"), "no");
  EXPECT_EQ(value(of("Motor Current"), "left_over_current"), "yes");
  EXPECT_EQ(value(of("Motor Current"), "right_over_current"), "no");
}

TEST_F(Diagnostics, GradesTheBattery) {
  rig.model.power().set_charge(0.2);
  EXPECT_EQ(of("Battery").level, Health::warn);
  rig.model.power().set_charge(0.0);
  EXPECT_EQ(of("Battery").level, Health::error);
}

TEST_F(Diagnostics, SaysWhyVelocitiesAreIgnored) {
  rig.driver.set_motor_power(false);
  EXPECT_EQ(of("Motor State").message, "off: velocities are ignored");
  rig.driver.set_motor_power(true);
  rig.driver.on_emergency_stop(true, rig.now);
  EXPECT_EQ(of("Motor State").level, Health::warn);
  EXPECT_EQ(of("Motor State").message, "held by the emergency stop: velocities are ignored");
  rig.driver.on_emergency_stop(false, rig.now);
  EXPECT_EQ(of("Motor State").level, Health::ok);
}

TEST_F(Diagnostics, CallsSensorsOfASilentBaseStale) {
  EXPECT_EQ(diagnose(rig.driver, nullptr).size(), 3U) << "before the first frame";
  rig.run(0.5);
  rig.silent = true;
  rig.run(1);
  EXPECT_EQ(of("Watchdog").level, Health::error);
  EXPECT_EQ(of("Battery").level, Health::stale);
  ASSERT_NE(rig.driver.last_reading(), nullptr);
  EXPECT_EQ(diagnose(rig.driver, rig.driver.last_reading()).size(), 11U);
}

TEST_F(Diagnostics, CountsDamagedFrames) {
  LineParams line;
  line.flip_probability = 0.01;
  rig.line.configure(line);
  rig.run(5);
  EXPECT_NE(value(of("Serial Line"), "frames_rejected"), "0");
}

TEST_F(Diagnostics, RefusesOtherFirmware) {
  ModelParams base = exact_model();
  base.firmware = "2.0.0";
  ModelRig other({}, base);
  other.run(1);
  EXPECT_EQ(find(diagnose(other.driver, &other.last), "Watchdog").level, Health::error);
}

}  // namespace
}  // namespace tocsin::kobuki
