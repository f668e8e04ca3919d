// SPDX-License-Identifier: Apache-2.0
// Services, parameters and actions of the vehicle, called at the station over the emulated radio.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/enclave.hpp"
#include "keystore/keystore.hpp"
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

const std::string traffic = TOCSIN_REPOSITORY "/components/examples/bringup/traffic.yaml";

/// The mission's vehicle with a talker, whose text can be changed while it runs.
class LinkCallsTest : public ::testing::Test {
 protected:
  /// `more`: words for `tocsin launch`. `mission`: the station's container of that name.
  explicit LinkCallsTest(const std::vector<std::string>& more = {},
                         const std::string& mission = "mission: ~")
      : stack_(arguments(more, mission)) {}
  /// A command of the station.
  [[nodiscard]] Ended at_station(const std::string& tool, const std::string& words) const {
    return run_to_end(command(tool, words), "");
  }
  /// A goal that is cancelled as soon as the vehicle has sent feedback.
  [[nodiscard]] Ended cancelled_goal() const {
    const std::string output = folder_.path("goal.txt");
    return run_to_end(
        "timeout 120 bash",
        fmt::format("-c '{} > {} & until grep -q Feedback {} || ! kill -0 $!; do sleep 0.1; done; "
                    "kill -INT $!; wait $!; cat {}'",
                    command("tocsin-action",
                            "send_goal /navigate_to_pose nav2_msgs/action/NavigateToPose \"{pose: "
                            "{pose: {position: {x: 2}}}}\" -f --timeout 60"),
                    output, output, output));
  }
  [[nodiscard]] std::string command(const std::string& tool, const std::string& words,
                                    const std::string& host = "gcs") const {
    return fmt::format("{} {} --run-dir {} --host {}", Stack::program(tool), words, stack_.folder(),
                       host);
  }
  [[nodiscard]] bool is_met() const {
    return stack_.logged("gcs is on the link") && stack_.logged("uxv is on the link");
  }

  const TemporaryFolder folder_;
  const Stack stack_;

 private:
  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& more,
                                                   const std::string& mission) const {
    const std::string file =
        folder_.write("calls.yaml",
                      "extends: mission.yaml\n"
                      "qos: " TOCSIN_REPOSITORY
                      "/components/examples/bringup/qos.yaml\n"
                      "traffic: " +
                          traffic +
                          "\n"
                          "stop_when_exits: ~\n"
                          "hosts:\n"
                          "  uxv: {containers: [{name: chat, components: [talker]}]}\n"
                          "  gcs: {containers: [{" +
                          mission + "}, {view: ~}, {page: ~}]}\n");
    std::vector<std::string> words{file, "--seed", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

/// Identities of both hosts as `tocsin keystore` makes them.
class Identities {
 public:
  Identities() {
    run("create");
    for (const char* const name : {"uxv", "gcs"}) {
      run(std::string("add ") + name + " --traffic " + traffic);
    }
  }
  [[nodiscard]] std::string path() const { return folder_.path("keystore"); }
  /// The station may not send on topics with this in their names.
  void withhold(const std::string& part) const {
    auto may = keystore::read_enclave(keystore::enclave_folder(path(), "gcs")).permissions.value();
    const auto is_withheld = [&](const std::string& topic) {
      return topic.find(part) != std::string::npos;
    };
    const auto kept = std::remove_if(may.publish.begin(), may.publish.end(), is_withheld);
    ASSERT_NE(kept, may.publish.end());
    may.publish.erase(kept, may.publish.end());
    keystore::permit(path(), "gcs", may);
  }

 private:
  void run(const std::string& words) const {
    const Ended ended =
        run_to_end(Stack::program("tocsin-keystore"), words + " --keystore " + path());
    ASSERT_EQ(ended.code, 0) << ended.output;
  }
  const TemporaryFolder folder_;
};

struct Permitted {
  const Identities identities;
};
class SecuredCallsTest : protected Permitted, public LinkCallsTest {
 protected:
  SecuredCallsTest() : LinkCallsTest({"--security", identities.path()}) {}
};

TEST_F(SecuredCallsTest, AreAnsweredAsOnAPlainLink) {
  ASSERT_TRUE(Stack::eventually(patience, [&] { return is_met(); })) << stack_.output();
  const Ended set = at_station("tocsin-param", "set /talker text sealed --timeout 60");
  ASSERT_EQ(set.code, 0) << set.output << stack_.output();
  EXPECT_THAT(at_station("tocsin-param", "get /talker text --timeout 60").output,
              HasSubstr("sealed"));
  const Ended goal = at_station("tocsin-action",
                                "send_goal /navigate_to_pose nav2_msgs/action/NavigateToPose "
                                "\"{pose: {pose: {position: {x: 0.1}}}}\" --timeout 60");
  EXPECT_THAT(goal.output, HasSubstr("Goal accepted")) << stack_.output();
}

TEST_F(SecuredCallsTest, OfAStationThatHasLostTheRightReachNobody) {
  ASSERT_TRUE(Stack::eventually(patience, [&] { return is_met(); })) << stack_.output();
  const Ended set = at_station("tocsin-param", "set /talker text allowed --timeout 60");
  ASSERT_EQ(set.code, 0) << set.output << stack_.output();
  // `tocsin launch` would refuse to start with it; its router alone starts again.
  identities.withhold("link_calls");
  ASSERT_EQ(kill(stack_.pid("gcs/link"), SIGKILL), 0);
  ASSERT_TRUE(Stack::eventually(patience, [&] { return stack_.logged("gcs/link ended"); }));
  const Ended forged = at_station("tocsin-param", "set /talker text forged --timeout 10");
  EXPECT_EQ(forged.code, 1) << forged.output;
  const Ended is = run_to_end(command("tocsin-param", "get /talker text --timeout 60", "uxv"), "");
  EXPECT_THAT(is.output, HasSubstr("allowed"));
}

TEST_F(LinkCallsTest, ParametersAndActionsOfTheVehicleWorkAtTheStationAndAnOutageIsSaidOnce) {
  ASSERT_TRUE(Stack::eventually(patience, [&] { return is_met(); })) << stack_.output();

  Ended set = at_station("tocsin-param", "set /talker text over-the-radio --timeout 60");
  ASSERT_EQ(set.code, 0) << set.output << stack_.output();
  EXPECT_THAT(set.output, HasSubstr("Set parameter successful"));
  const Ended get = at_station("tocsin-param", "get /talker text --timeout 60");
  EXPECT_THAT(get.output, HasSubstr("over-the-radio"));

  const Ended goal = cancelled_goal();
  EXPECT_THAT(goal.output, HasSubstr("Goal accepted"));
  EXPECT_THAT(goal.output, HasSubstr("Feedback:"));
  EXPECT_THAT(goal.output, HasSubstr("Goal canceled."));

  BusOptions options;
  options.name = "standing";
  options.host_domain = standing_domain + 1;
  const Peer standing(stack_.running("gcs/link"), options, [](Bus& bus) {
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

/// A mission control that waits for goals.
class FollowWaypointsTest : public LinkCallsTest {
 protected:
  FollowWaypointsTest()
      : LinkCallsTest({},
                      "name: mission, components: [{component: mission_control, parameters: "
                      "{mission_file: '', exit_when_over: false}}]") {}
  /// Poses at these places, y is 0.
  [[nodiscard]] static std::string send_goal(const std::vector<double>& xs) {
    std::string poses;
    for (const double x : xs) poses += fmt::format("{{pose: {{position: {{x: {}}}}}}}, ", x);
    return fmt::format(
        "send_goal /follow_waypoints nav2_msgs/action/FollowWaypoints \"{{poses: [{}]}}\" -f "
        "--timeout 60",
        poses);
  }
  /// Where the station knows the vehicle to be; NaN when it does not [m].
  [[nodiscard]] double x() const {
    const Ended echo = at_station("tocsin-topic", "echo /location --once");
    const std::string before = "position:\n      x: ";
    const std::size_t at = echo.output.find(before);
    return at == std::string::npos ? std::nan("")
                                   : std::stod(echo.output.substr(at + before.size()));
  }
};

TEST_F(FollowWaypointsTest, AGoalOfTheStationIsCanceledMidwayAndOneOfTheVehicleReachesItsEnd) {
  ASSERT_TRUE(Stack::eventually(patience, [&] { return is_met(); })) << stack_.output();

  // Cancelled between the first pose and the second.
  const std::string output = folder_.path("goal.txt");
  const Ended goal = run_to_end(
      "timeout 120 bash",
      fmt::format("-c '{} > {} & until grep -q \"current_waypoint: 1\" {} || ! kill -0 $!; do "
                  "sleep 0.1; done; kill -INT $!; wait $!; cat {}'",
                  command("tocsin-action", send_goal({0.5, 2.5})), output, output, output));
  EXPECT_THAT(goal.output, HasSubstr("current_waypoint: 0"));
  EXPECT_THAT(goal.output, HasSubstr("Goal canceled.")) << stack_.output();
  const double stands_at = x();
  EXPECT_GT(stands_at, 0.2);
  EXPECT_LT(stands_at, 2);
  EXPECT_NEAR(x(), stands_at, 0.05);

  const Ended back = run_to_end(command("tocsin-action", send_goal({0}), "uxv"), "");
  EXPECT_THAT(back.output, HasSubstr("SUCCEEDED")) << stack_.output();
  EXPECT_NEAR(x(), 0, 0.3);
}

}  // namespace
}  // namespace tocsin
