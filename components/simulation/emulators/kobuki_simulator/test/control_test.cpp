// SPDX-License-Identifier: Apache-2.0
#include "control.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

struct Control : ::testing::Test {
  std::string say(const std::string& line) { return obey_control(sut, line, t0); }
  nlohmann::json state() { return nlohmann::json::parse(say("get")); }
  SimulatedBase sut{BaseModel(ModelParams{}, open_floor(), {1, 2, 0.5}, 1, t0),
                    SerialLine(LineParams{}, 2, t0)};
};

TEST_F(Control, ShowsTheState) {
  const auto got = state();
  EXPECT_EQ(got["x"], 1.0);
  EXPECT_EQ(got["yaw"], 0.5);
  EXPECT_EQ(got["outputs"], 0xF0);
  EXPECT_EQ(got["plugged"], true);
  EXPECT_EQ(got["kp"], 100.0);
}

TEST_F(Control, SetsInputsPowerAndLineFaults) {
  EXPECT_EQ(say("set bumper=5 cliff=1 wheel_drop=2 buttons=4 charger=adapter charge=0.5 digital=3"),
            "ok");
  EXPECT_EQ(state()["bumper"], 5);
  EXPECT_EQ(state()["charger"], 22);
  EXPECT_EQ(state()["charge"], 0.5);
  EXPECT_EQ(sut.model().inputs().digital, 3);
  EXPECT_EQ(say("set dock_centre=8 charger=none analog0=1 analog3=4095"), "ok");
  EXPECT_EQ(sut.model().inputs().dock.centre, 8);
  EXPECT_EQ(state()["analog"][0], 1);
  EXPECT_EQ(state()["analog"][3], 4095);
  EXPECT_EQ(say("set usb_latency_ms=16 usb_packet_bytes=32 flip=0.1 loss=0.2 noise=0.3"), "ok");
  EXPECT_EQ(sut.line().params().usb_latency_ms, 16);
  EXPECT_EQ(sut.line().params().usb_packet_bytes, 32);
  EXPECT_EQ(sut.line().params().loss_probability, 0.2);
}

TEST_F(Control, ChangesNothingWhenOneEntryIsBad) {
  for (const char* bad :
       {"bumper=256", "bumper=-1", "bumper=1.5", "bumper=x", "charge=1.1", "charger=sun",
        "loss=nan", "usb_latency_ms=0", "usb_latency_ms=17", "usb_packet_bytes=63", "unknown=1",
        "bumper", "analog4=1", "analog0=4096"}) {
    EXPECT_EQ(say(std::string("set cliff=1 ") + bad),
              std::string("error: cannot set '") + bad + "'");
    EXPECT_EQ(state()["cliff"], 0) << bad;
  }
}

TEST_F(Control, ShowsLedsSoundsAndEncoders) {
  OutputRegister outputs;
  outputs.set_led(1, true, true);
  outputs.set_led(2, false, true);
  for (const Command& command : {Command{outputs}, Command{Tune::error}, Command{Tone{826, 50}}}) {
    sut.receive(encode_command(command).bytes(), t0);
  }
  EXPECT_EQ(state()["led1"], "orange");
  EXPECT_EQ(state()["led2"], "green");
  EXPECT_EQ(state()["tune"], 4);
  EXPECT_NEAR(state()["tone_hz"].get<double>(), 440, 1);
  EXPECT_TRUE(state()["left_ticks"].is_number());
  EXPECT_EQ(state()["line"]["usb_latency_ms"], 1);
}

TEST_F(Control, SetsVersionsAlsoOldOnes) {
  EXPECT_EQ(say("version 1.0.3 1.1.4"), "ok");
  EXPECT_EQ(state()["firmware"], "1.1.4");
  EXPECT_FALSE(sut.model().firmware().old_code);
  EXPECT_EQ(say("version 1.0.3 1.0.0 old"), "ok");
  EXPECT_EQ(sut.model().firmware().old_code, 123);
  EXPECT_EQ(say("version 1.0.3 new").substr(0, 6), "error:");
  EXPECT_EQ(state()["firmware"], "1.0.0");
}

TEST_F(Control, SetsGainsAndPlaceAndPullsTheCable) {
  EXPECT_EQ(say("gains 50 0.2 3"), "ok");
  EXPECT_EQ(state()["kp"], 50.0);
  EXPECT_EQ(say("place 3 -4 1.5"), "ok");
  EXPECT_EQ(state()["y"], -4.0);
  EXPECT_EQ(say("unplug"), "ok");
  EXPECT_EQ(state()["plugged"], false);
  EXPECT_EQ(say("plug"), "ok");
  EXPECT_EQ(state()["plugged"], true);
  EXPECT_EQ(say("unplug 1"), "ok");
  EXPECT_TRUE(sut.plugged(t0 + seconds(1)));
  EXPECT_EQ(say("silence 2"), "ok");
  EXPECT_EQ(say("reset"), "ok");
}

TEST_F(Control, RefusesWhatItDoesNotKnow) {
  for (const auto& [line, answer] : {std::pair("gains 50 -1 3", "gains P I D"),
                                     {"gains 50", "gains P I D"},
                                     {"place 3 -4", "place X Y YAW"},
                                     {"unplug soon", "unplug [SECONDS]"},
                                     {"silence", "silence SECONDS"},
                                     {"dance", "unknown command 'dance'"},
                                     {"", "unknown command ''"}}) {
    EXPECT_EQ(say(line), std::string("error: ") + answer);
  }
}

}  // namespace
}  // namespace tocsin::kobuki
