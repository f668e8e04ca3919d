// SPDX-License-Identifier: Apache-2.0
// A vehicle, its site, and a second station behind the site's relay, each launched alone, as on
// three computers that share the loopback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class SecondStationTest : public ::testing::Test {
 protected:
  SecondStationTest()
      : fleet_(files_.write("fleet.yaml",
                            "extends: fleet.yaml\ndomain: 20\nstop_when_exits: ~\nvehicles:\n"
                            "  uxv1: {address: 127.0.0.1, variables: {mission: ./mission.yaml}}\n"
                            "  uxv2: ~\n  uxv3: ~\n  uxv4: ~\n  uxv5: ~\n"
                            "hosts: {uxv: {peers: [127.0.0.1]}, gcs: {address: 127.0.0.1}}\n")),
        second_(files_.write(
            "second.yaml",
            "extends: second_station.yaml\ndomain: 30\n"
            "vehicles: {uxv2: ~, uxv3: ~, uxv4: ~, uxv5: ~}\n"
            "hosts:\n"
            "  site: {domain: 21, address: 127.0.0.1, peers: [127.0.0.1]}\n"
            "  desk:\n    address: 127.0.0.1\n    peers: [127.0.0.1]\n    containers:\n"
            "      - {name: log, each_vehicle: true, components: [recorder]}\n")) {
    std::string mission = "name: long\nframe: map\nwaypoints:\n";
    for (int i = 0; i < 20; ++i)
      mission +=
          i % 2 == 0 ? "  - {x: 2.5, y: -1.0, yaw: 0.0}\n" : "  - {x: 1.0, y: -0.4, yaw: 0.0}\n";
    files_.write("mission.yaml", mission);
    vehicle_.emplace(alone(fleet_, "uxv1", "camera"));
    station_.emplace(alone(fleet_, "gcs", "page"));
    relay_.emplace(std::vector<std::string>{second_, "--host", "site"});
    desk_.emplace(alone(second_, "desk", "page"));
  }
  static std::vector<std::string> alone(const std::string& file, const char* host,
                                        const char* without) {
    return {file, "--host", host, "--without", without};
  }
  [[nodiscard]] static Ended estop(const std::string& order, const Stack& station) {
    return run_to_end(Stack::program("tocsin-estop"), order + " --run-dir " + station.folder());
  }
  [[nodiscard]] static bool says_that_it_stands(const Stack& station) {
    return estop("status", station).output.find("stands by emergency stop of") != std::string::npos;
  }
  /// By the last two locations that the vehicle has recorded, 0.2 s apart.
  [[nodiscard]] bool drives() const { return moves_in(vehicle_->recorded("uxv1/uxv", "location")); }
  [[nodiscard]] bool will_drive() const {
    return Stack::eventually(seconds(60), [&] { return drives(); });
  }
  [[nodiscard]] bool will_stand() const {
    return Stack::eventually(seconds(10), [&] { return !drives(); });
  }
  [[nodiscard]] std::vector<std::string> at_desk(const std::string& topic,
                                                 const std::string& field) const {
    return column(desk_->recorded("uxv1/gcs", topic), field);
  }
  [[nodiscard]] bool hears_location() const {
    return Stack::eventually(
        seconds(60), [&] { return at_desk("location", "pose.pose.position.x").size() > 20; });
  }
  [[nodiscard]] std::string all_output() const {
    return vehicle_->output() + station_->output() + relay_->output() + desk_->output();
  }

  const TemporaryFolder files_;
  const std::string fleet_;
  const std::string second_;
  std::optional<Stack> vehicle_;
  std::optional<Stack> station_;
  std::optional<Stack> relay_;
  std::optional<Stack> desk_;
};

TEST_F(SecondStationTest, HearsTheVehicleStopsItAndLeadsIt) {
  ASSERT_TRUE(will_drive()) << all_output();
  ASSERT_TRUE(hears_location()) << all_output();
  const auto own = column(vehicle_->recorded("uxv1/uxv", "location"), "pose.pose.position.x");
  const std::set<std::string> places(own.begin(), own.end());
  for (const std::string& place : at_desk("location", "pose.pose.position.x"))
    EXPECT_EQ(places.count(place), 1u) << place;
  EXPECT_THAT(at_desk("mission_status", "state"), Not(IsEmpty())) << "which the site says";

  const Ended on = estop("on", *desk_);
  EXPECT_EQ(on.code, 0) << on.output;
  EXPECT_TRUE(will_stand());
  EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return says_that_it_stands(*desk_); }));
  const Ended not_its_own = estop("off", *station_);
  EXPECT_NE(not_its_own.code, 0) << "who pressed must release: " << not_its_own.output;
  EXPECT_FALSE(drives());
  const Ended off = estop("off", *desk_);
  EXPECT_EQ(off.code, 0) << off.output;
  EXPECT_TRUE(will_drive()) << all_output();

  const Ended at_site = estop("on", *station_);
  EXPECT_EQ(at_site.code, 0) << at_site.output;
  EXPECT_TRUE(will_stand());
  EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return says_that_it_stands(*desk_); }));
  EXPECT_EQ(estop("off", *station_).code, 0) << "the second station has not taken it for its own";
  EXPECT_TRUE(will_drive()) << all_output();

  const Ended goal = run_to_end(
      Stack::program("tocsin-action"),
      "send_goal /uxv1/follow_waypoints nav2_msgs/action/FollowWaypoints \"{poses: [{pose: "
      "{position: {x: 1.2, y: -0.5}}}]}\" --timeout 60 --domain 31");
  EXPECT_THAT(goal.output, HasSubstr("SUCCEEDED")) << all_output();
}

TEST_F(SecondStationTest, AStopOfAStationThatHasGoneEndsAtTheSite) {
  ASSERT_TRUE(will_drive()) << all_output();
  ASSERT_TRUE(hears_location()) << all_output();
  ASSERT_EQ(estop("on", *desk_).code, 0) << all_output();
  ASSERT_TRUE(will_stand());
  const pid_t link = desk_->pid("desk/uxv1_link");
  ASSERT_NE(link, 0);
  kill(desk_->launcher(), SIGKILL);
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] { return kill(link, 0) != 0; }));
  EXPECT_FALSE(drives());
  EXPECT_TRUE(Stack::eventually(seconds(30), [&] { return estop("off", *station_).code == 0; }))
      << all_output();
  EXPECT_TRUE(will_drive()) << all_output();
}

}  // namespace
}  // namespace tocsin
