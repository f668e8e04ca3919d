// SPDX-License-Identifier: Apache-2.0
// The RPLIDAR of the simulated base behind its pseudo-terminal, read by its driver: what is
// recorded of its topic, over a cable that is pulled and a motor that is held.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

constexpr const char* standing_with_laser =
    "extends: mission.yaml\n"
    "domain: 52\n"
    "stop_when_exits: ~\n"
    "hosts:\n"
    "  uxv:\n"
    "    programs:\n"
    "      - name: base\n"
    "        command: [kobuki_simulator, --link, '${run_dir}/kobuki', --walls,\n"
    "          '${share}/config/maps/classroom.walls.yaml', --control, '${run_dir}/base.sock',\n"
    "          --laser, '${run_dir}/rplidar', --obstacles,\n"
    "          '${share}/config/maps/classroom.obstacles.yaml']\n"
    "    containers:\n"
    "      - name: laser\n"
    "        components:\n"
    "          - {component: rplidar_driver, parameters: {device_port: '${run_dir}/rplidar'}}\n"
    "      - name: recorder\n"
    "        components:\n"
    "          - {component: recorder, parameters: {topics: [scan, tf_static]}}\n"
    "  gcs: {containers: [{mission: ~}, {view: ~}, {page: ~}]}\n";

class LaserTest : public ::testing::Test {
 protected:
  LaserTest() : stack_({folder_.write("laser.yaml", standing_with_laser), "--seed", "1"}) {}

  [[nodiscard]] std::size_t turns() const {
    return column(stack_.recorded("uxv", "scan"), "range_max").size();
  }
  [[nodiscard]] bool more_turns() const {
    const std::size_t before = turns();
    return Stack::eventually(seconds(30), [&] { return turns() > before + 10; });
  }
  /// The log, as soon as it has said `text`.
  [[nodiscard]] bool says(const std::string& text) const {
    return Stack::eventually(seconds(20), [&] { return stack_.logged(text); });
  }
  void laser(const std::string& verb) const { stack_.control("base.sock", "laser " + verb); }

  const TemporaryFolder folder_;
  const Stack stack_;
};

TEST_F(LaserTest, ScansOverAPulledCableAndAHeldMotor) {
  ASSERT_TRUE(more_turns()) << stack_.output();
  laser("unplug");
  EXPECT_TRUE(says("was lost"));
  laser("plug");
  EXPECT_TRUE(more_turns());
  laser("stall");
  EXPECT_TRUE(says("it does not turn"));
  laser("free");
  EXPECT_TRUE(more_turns());
}

}  // namespace
}  // namespace tocsin
