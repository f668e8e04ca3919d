// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/events.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "frames.hpp"

namespace tocsin::kobuki {
namespace {

Feedback charged_for(int charger, int dv = 158) {
  Feedback feedback = typical_feedback(1);
  feedback.core->charger = static_cast<std::uint8_t>(charger);
  feedback.core->battery_dv = static_cast<std::uint8_t>(dv);
  return feedback;
}

std::vector<PowerEvent> power_events(EventDetector& sut, const Feedback& feedback, int times = 1) {
  std::vector<PowerEvent> events;
  for (int i = 0; i < times; ++i) {
    for (const Event& event : sut.update(feedback)) {
      if (const auto* power = std::get_if<PowerEvent>(&event)) events.push_back(*power);
    }
  }
  return events;
}

using Power = std::vector<PowerEvent>;

TEST(Events, ReportBothEdgesOfEachSide) {
  EventDetector sut{BatteryParams{}};
  EXPECT_TRUE(sut.update(Feedback{}).empty());
  Feedback feedback = typical_feedback(1);
  EXPECT_TRUE(sut.update(feedback).empty());
  feedback.core->buttons = 4;
  const Events pressed = sut.update(feedback);
  ASSERT_EQ(pressed.size(), 1U);
  EXPECT_EQ(std::get<ButtonEvent>(*pressed.begin()).button, 2);
  EXPECT_TRUE(std::get<ButtonEvent>(*pressed.begin()).pressed);
  EXPECT_TRUE(sut.update(feedback).empty());
  feedback.core->buttons = 0;
  EXPECT_FALSE(std::get<ButtonEvent>(*sut.update(feedback).begin()).pressed);
  feedback.core->bumper = left_bit | right_bit;
  const Events bumped = sut.update(feedback);
  ASSERT_EQ(bumped.size(), 2U);
  EXPECT_EQ(std::get<BumperEvent>(bumped.begin()[0]).side, Side::left);
  EXPECT_EQ(std::get<BumperEvent>(bumped.begin()[1]).side, Side::right);
  feedback.core->wheel_drop = left_wheel_drop_bit;
  EXPECT_EQ(std::get<WheelDropEvent>(*sut.update(feedback).begin()).side, Side::left);
  feedback.core->wheel_drop = right_bit;
  EXPECT_EQ(sut.update(feedback).size(), 2U);  // left raised, right dropped
}

TEST(Events, CarryTheAdcOfTheirOwnCliffSensorAndFrame) {
  EventDetector sut{BatteryParams{}};
  Feedback feedback = typical_feedback(1);
  feedback.core->cliff = left_bit | centre_bit | right_bit;
  feedback.cliff_adc = CliffAdc{1001, 1002, 1003};
  const Events events = sut.update(feedback);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(std::get<CliffEvent>(events.begin()[0]).adc, 1003);  // left; the reference says 1001
  EXPECT_EQ(std::get<CliffEvent>(events.begin()[1]).adc, 1002);
  EXPECT_EQ(std::get<CliffEvent>(events.begin()[2]).adc, 1001);
}

TEST(Events, ReportDigitalInputs) {
  EventDetector sut{BatteryParams{}};
  Feedback feedback = typical_feedback(1);
  feedback.input->digital = 0x0045;  // the test board bit is no input
  const Events events = sut.update(feedback);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(std::get<InputEvent>(*events.begin()).values,
            (std::array<bool, 4>{true, false, true, false}));
  feedback.input->digital = 0x0005;
  EXPECT_TRUE(sut.update(feedback).empty());
}

TEST(Events, ReportPluggingFromAnySourceToAnyOther) {
  EventDetector sut{BatteryParams{}};
  EXPECT_EQ(power_events(sut, charged_for(22)), Power{PowerEvent::plugged_to_adapter});
  // The reference is silent on this swap: the charging state stays.
  EXPECT_EQ(power_events(sut, charged_for(6)), Power{PowerEvent::plugged_to_dock});
  EXPECT_EQ(power_events(sut, charged_for(0)), Power{PowerEvent::unplugged});
}

TEST(Events, ReportChargedOnlyWhenItLasts) {
  EventDetector sut{BatteryParams{}};
  EXPECT_EQ(power_events(sut, charged_for(2), 49), Power{PowerEvent::plugged_to_dock});
  EXPECT_EQ(power_events(sut, charged_for(6), 10),
            Power{});  // it was the flicker after plugging in
  EXPECT_EQ(power_events(sut, charged_for(2), 49), Power{});
  EXPECT_EQ(power_events(sut, charged_for(2), 1), Power{PowerEvent::charge_completed});
  EXPECT_EQ(power_events(sut, charged_for(2), 500), Power{});
}

TEST(Events, ReportLowAndCriticalOnceUntilItIsCharged) {
  EventDetector sut{BatteryParams{}};
  EXPECT_EQ(power_events(sut, charged_for(0, 141)), Power{});
  EXPECT_EQ(power_events(sut, charged_for(0, 140)), Power{PowerEvent::battery_low});
  for (const int dv : {141, 140, 133}) EXPECT_EQ(power_events(sut, charged_for(0, dv)), Power{});
  EXPECT_EQ(power_events(sut, charged_for(0, 132)), Power{PowerEvent::battery_critical});
  EXPECT_EQ(power_events(sut, charged_for(6, 150)), Power{PowerEvent::plugged_to_dock});
  EXPECT_EQ(power_events(sut, charged_for(0, 140)),
            (Power{PowerEvent::unplugged, PowerEvent::battery_low}));
}

// The reference driver sends an event with an uninitialised code here.
TEST(Events, AreSilentWhenTheLevelFallsFromFullToHealthy) {
  EventDetector sut{BatteryParams{}};
  (void)power_events(sut, charged_for(18), 100);
  EXPECT_EQ(power_events(sut, charged_for(0, 158)), Power{PowerEvent::unplugged});
  EXPECT_EQ(power_events(sut, charged_for(0, 150), 10), Power{});
}

TEST(Events, FitWhenEverythingChangesAtOnce) {
  EventDetector sut{BatteryParams{}};
  Feedback feedback = charged_for(0x12, 100);
  feedback.core->buttons = feedback.core->bumper = feedback.core->cliff = 0xFF;
  feedback.core->wheel_drop = 0xFF;
  feedback.input->digital = 0xFFFF;
  EXPECT_EQ(sut.update(feedback).size(), 13U);
}

}  // namespace
}  // namespace tocsin::kobuki
