// SPDX-License-Identifier: Apache-2.0
// Two emulated radios: the first one dies and comes back while samples of class critical cross, and
// while somebody stops the vehicle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#include "crossing.hpp"
#include "emergency_stop_rig.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using Way = Crossings::Way;

constexpr double late_after_s = 0.25;
constexpr double samples_per_s = 200;

/// A standing mission with a modem beside its radio, which is never worse than now.
std::string with_a_modem(const std::string& folder) {
  (void)standing_mission(folder);
  std::ofstream(folder + "/modem.yaml")
      << "radio_channel: {mode: bernoulli, loss: 0.002, delay_s: 0.03, rate_mbit_s: 1}\n";
  std::string file = folder + "/two.yaml";
  std::ofstream(file) << "extends: standing.yaml\n"
                         "radio:\n"
                         "  channel: ${share}/config/radio/open.yaml\n"
                         "  walls: ${share}/config/maps/classroom.walls.yaml\n"
                         "  second: modem.yaml\n"
                         "hosts:\n"
                         "  uxv: {second: {address: 10.78.0.1, peers: [10.78.0.2]}}\n"
                         "  gcs: {second: {address: 10.78.0.2, peers: [10.78.0.1]}}\n";
  return file;
}

/// What of it is missing or late: times of writing [s], for a person to read.
std::string holes(const Crossings& crossings, Way way, std::int64_t from_ns) {
  std::string text;
  double last_s = 0;
  for (const Crossed& one : crossings.all(way)) {
    const double sent_s = 1e-9 * static_cast<double>(one.sent_ns - from_ns);
    const double age_s = 1e-9 * static_cast<double>(one.received_ns - one.sent_ns);
    if (sent_s < 0 || age_s > late_after_s) continue;
    if (sent_s - last_s > 0.02) text += fmt::format(" {:.3f} to {:.3f}", last_s, sent_s);
    last_s = sent_s;
  }
  return text;
}

/// Share of what was written between two times that was there in 250 ms.
double in_time(const Crossings& crossings, Way way, std::int64_t from_ns, double length_s) {
  const auto until_ns = from_ns + static_cast<std::int64_t>(1e9 * length_s);
  const auto all = crossings.all(way);
  const auto count = std::count_if(all.begin(), all.end(), [&](const Crossed& one) {
    const double age_s = 1e-9 * static_cast<double>(one.received_ns - one.sent_ns);
    return one.sent_ns >= from_ns && one.sent_ns < until_ns && age_s <= late_after_s;
  });
  return static_cast<double>(count) / (samples_per_s * length_s);
}

TEST(TwoPaths, CriticalSamplesCrossInTimeWhileTheFirstRadioIsDeadAndAfterIt) {
  const TemporaryFolder folder;
  // Pictures would wait in the modem, too, and others behind them.
  const Stack stack({with_a_modem(folder.path()), "--seed", "1", "--without", "uxv/payload"});
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  const Crossings crossings(stack.running("uxv/link"), stack.running("gcs/link"), standing_domain);
  const auto cross = [&](Way way) { return crossings.all(way).size() > 600; };
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return cross(Way::up) && cross(Way::down); }))
      << stack.output();
  const std::int64_t dies_ns = wall_now_ns();
  stack.control("radio.sock", "set outage 8");
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] {
    return crossings.first_after(Way::up, dies_ns + 12'000'000'000) &&
           crossings.first_after(Way::down, dies_ns + 12'000'000'000);
  })) << stack.output();
  for (const Way way : {Way::up, Way::down}) {
    // 0.3 to 0.4 s alone; what a newer sample has followed meanwhile is not sent again.
    EXPECT_LT(crossings.longest_gap_s(way, dies_ns), 0.8);
    EXPECT_GE(in_time(crossings, way, dies_ns, 7), 0.9) << "dead" << holes(crossings, way, dies_ns);
    // What a faster path overtakes when it is chosen again is not delivered behind it.
    EXPECT_GE(in_time(crossings, way, dies_ns + 7'000'000'000, 5), 0.95)
        << "and back" << holes(crossings, way, dies_ns);
  }
}

class TwoPathsStop : public EmergencyStopTest {};

TEST_F(TwoPathsStop, AStopReachesTheVehicleByTheSecondPathAlone) {
  bringup_ = "two_paths.yaml";
  drive();
  stack_->control("radio.sock", "set outage 60");
  std::this_thread::sleep_for(seconds(2));
  EXPECT_TRUE(moves()) << "by what the modem carries\n" << stack_->output();
  EXPECT_EQ(estop({"on"}), 0) << said();
  EXPECT_TRUE(stands());
  EXPECT_EQ(estop({"off"}), 0) << said();
  EXPECT_TRUE(moves());
}

}  // namespace
}  // namespace tocsin
