// SPDX-License-Identifier: Apache-2.0
// Services, parameters and actions of the vehicle, called at the station over the emulated radio.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

constexpr auto patience = seconds(60);

/// A client of the station that stays, so that the service does, too.
class Standing final : public ClientReceiver {
 public:
  explicit Standing(Bus& bus)
      : end_(bus.call(
            {"talker/set_parameters", &type_info<rcl_interfaces::srv::SetParameters_Request>(),
             &type_info<rcl_interfaces::srv::SetParameters_Response>()},
            *this)) {}
  void receive(ServiceReply&&) override {}
  void wake() override {}

 private:
  std::unique_ptr<ClientEnd> end_;
};

/// The mission's vehicle with a talker, whose text can be changed while it runs.
class LinkCallsTest : public ::testing::Test {
 protected:
  LinkCallsTest()
      : stack_({folder_.write("calls.yaml",
                              "extends: mission.yaml\n"
                              "qos: " TOCSIN_REPOSITORY "/components/examples/bringup/qos.yaml\n"
                              "traffic: " TOCSIN_REPOSITORY
                              "/components/examples/bringup/traffic.yaml\n"
                              "stop_when_exits: ~\n"
                              "hosts:\n"
                              "  uxv: {containers: [{name: chat, components: [talker]}]}\n"
                              "  gcs: {containers: [{mission: ~}, {view: ~}, {page: ~}]}\n"),
                "--seed", "1"}) {}
  /// A command of the station.
  [[nodiscard]] Ended at_station(const std::string& tool, const std::string& words) const {
    return run_to_end(command(tool, words), "");
  }
  [[nodiscard]] std::string command(const std::string& tool, const std::string& words) const {
    return fmt::format("{} {} --run-dir {} --host gcs", Stack::program("topic_tool", tool), words,
                       stack_.folder());
  }
  [[nodiscard]] bool is_met() const {
    return stack_.logged("gcs is on the link") && stack_.logged("uxv is on the link");
  }

  const TemporaryFolder folder_;
  const Stack stack_;
};

TEST_F(LinkCallsTest, ParametersAndActionsOfTheVehicleWorkAtTheStationAndAnOutageIsSaidOnce) {
  ASSERT_TRUE(Stack::eventually(patience, [&] { return is_met(); })) << stack_.output();

  Ended set = at_station("tocsin-param", "set /talker text over-the-radio --timeout 60");
  ASSERT_EQ(set.code, 0) << set.output << stack_.output();
  EXPECT_THAT(set.output, HasSubstr("Set parameter successful"));
  const Ended get = at_station("tocsin-param", "get /talker text --timeout 60");
  EXPECT_THAT(get.output, HasSubstr("over-the-radio"));

  // A goal is cancelled as soon as the vehicle has told how it goes.
  const std::string output = folder_.path("goal.txt");
  const Ended goal = run_to_end(
      "timeout 120 bash",
      fmt::format("-c '{} > {} & until grep -q Feedback {} || ! kill -0 $!; do sleep 0.1; done; "
                  "kill -INT $!; wait $!; cat {}'",
                  command("tocsin-action",
                          "send_goal /navigate_to_pose nav2_msgs/action/NavigateToPose \"{pose: "
                          "{pose: {position: {x: 2}}}}\" -f --timeout 60"),
                  output, output, output));
  EXPECT_THAT(goal.output, HasSubstr("Goal accepted"));
  EXPECT_THAT(goal.output, HasSubstr("Feedback:"));
  EXPECT_THAT(goal.output, HasSubstr("Goal canceled."));

  BusOptions options;
  options.name = "standing";
  options.host_domain = standing_domain + 1;
  const Peer standing(stack_.pid("gcs/link"), options, [](Bus& bus) {
    const Standing client(bus);
    for (;;) pause();
  });
  set = at_station("tocsin-param", "set /talker text before --timeout 60");
  ASSERT_EQ(set.code, 0) << set.output;
  stack_.control("radio.sock", "set outage 8");
  set = at_station("tocsin-param", "set /talker text lost --timeout 2");
  EXPECT_EQ(set.code, 1) << set.output;
  EXPECT_THAT(set.output, HasSubstr("no answer"));
  EXPECT_TRUE(Stack::eventually(patience, [&] {
    return stack_.logged("a call of /talker/set_parameters has no reply, and is given up");
  })) << stack_.output();
  set = at_station("tocsin-param", "set /talker text after --timeout 60");
  EXPECT_EQ(set.code, 0) << set.output;
}

}  // namespace
}  // namespace tocsin
