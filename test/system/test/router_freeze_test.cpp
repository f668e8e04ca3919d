// SPDX-License-Identifier: Apache-2.0
// The router of a host is frozen (SIGSTOP) and goes on, for less and for more than the lease of a
// participant on its host: real processes, real DDS, an emulated radio.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "operator_process.hpp"
#include "peer.hpp"
#include "recorded.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

constexpr int domain = 40;  // of bringup/mission.yaml

/// Samples of one writer that one side has recorded, by their time of sending: times of arrival.
using Arrivals = std::map<double, double>;
using Streams = std::map<std::string, Arrivals>;

/// Not written again by itself: a line of a log, a stop that was released, what it changed, a goal
/// that the vehicle has.
bool is_of_events(const std::string& stream) {
  for (const char* topic : {"rosout ", "emergency_stop ", "safety_status ", "goal "}) {
    if (stream.rfind(topic, 0) == 0) return true;
  }
  return false;
}

class RouterFreezeTest : public ::testing::Test {
 protected:
  RouterFreezeTest() : stack_({"mission.yaml", "--seed", "1", "--without", "gcs/view"}) {}

  void drive() {
    ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack_.pid("gcs/mission") != 0; }))
        << stack_.output();
    wheels_ = stack_.scratch() + "/wheels";
    watch_.emplace(stack_.running("uxv/recorder"), on_host(domain), watch_wheels(wheels_));
    ASSERT_TRUE(moves()) << stack_.output();
    std::this_thread::sleep_for(seconds(4));  // so that what comes once a second is known
  }
  /// What both sides have recorded since a time, of both sides' writers.
  [[nodiscard]] Streams recorded(double since_s) const {
    Streams streams;
    for (const std::string side : {"uxv", "gcs"}) {
      const std::string csv = recorded_messages(stack_.path(side));
      const auto sent = column(csv, "send_s");
      const auto received = column(csv, "receive_s");
      const auto topics = column(csv, "topic");
      const auto writers = column(csv, "writer");
      for (std::size_t i = 0; i < writers.size(); ++i) {
        const double at = std::stod(sent[i]);
        if (at < since_s) continue;
        streams[topics[i] + " of " + writers[i] + " at " + side][at] = std::stod(received[i]);
      }
    }
    return streams;
  }
  /// Freezes a router and returns when it goes on.
  double freeze(const std::string& router, seconds time) const {
    const pid_t pid = stack_.pid(router);
    if (pid <= 0) throw std::runtime_error(router + " does not run");  // 0 would be this process
    kill(pid, SIGSTOP);
    std::this_thread::sleep_for(time);
    kill(pid, SIGCONT);
    return wall_s();
  }
  /// Each stream that was received at least once a second before is received again within 2 s.
  void expect_all_again(const Streams& before, double thawed_s) const {
    std::this_thread::sleep_for(seconds(3));
    const Streams after = recorded(thawed_s);
    int expected = 0;
    for (const auto& [stream, arrivals] : before) {
      if (arrivals.size() < 3 || is_of_events(stream)) continue;
      ++expected;
      const auto again = after.find(stream);
      if (again == after.end()) {
        ADD_FAILURE() << stream << " is not received";
      } else {
        EXPECT_LT(again->second.begin()->second - thawed_s, 2.0) << stream;
      }
    }
    EXPECT_GT(expected, 20) << "heartbeats, states and locations, each at both sides";
  }
  /// `tocsin estop` as a person types it; its exit code.
  [[nodiscard]] int estop(const std::string& what) const {
    return OperatorProcess({Stack::program("tocsin-estop"), what, "--run-dir", stack_.folder()},
                           stack_.scratch() + "/said")
        .exit_code(seconds(10));
  }
  [[nodiscard]] bool moves() const {
    const double now = wall_s();
    return Stack::eventually(seconds(20), [&] { return last_moved(wheels_) > now; });
  }
  [[nodiscard]] bool stands() const {
    const double rests = wall_s() + 1.5;
    return Stack::eventually(seconds(10), [&] { return last_seen(wheels_) > rests + 1; }) &&
           last_moved(wheels_) <= rests;
  }
  /// Freezes a router, and expects the streams back and that the stop stops the wheels.
  void freeze_and_stop(const std::string& router, seconds time) const {
    SCOPED_TRACE(router + " frozen for " + std::to_string(time.count()) + " s");
    const Streams before = recorded(wall_s() - 4);
    expect_all_again(before, freeze(router, time));
    EXPECT_EQ(estop("on"), 0);
    EXPECT_TRUE(stands());
    EXPECT_EQ(estop("off"), 0);
    EXPECT_TRUE(moves());
  }

  Stack stack_;
  std::string wheels_;
  std::optional<Peer> watch_;
};

TEST_F(RouterFreezeTest, EveryStreamIsReceivedAgainWithinTwoSecondsAndTheStopStops) {
  ASSERT_NO_FATAL_FAILURE(drive());
  for (const int time : {1, 5}) {
    freeze_and_stop("gcs/link", seconds(time));
    freeze_and_stop("uxv/link", seconds(time));
  }
}

TEST_F(RouterFreezeTest, ALongFreezeOfTheStationsRouterDoesNotMuteTheStop) {
  ASSERT_NO_FATAL_FAILURE(drive());
  const Streams before = recorded(wall_s() - 4);
  expect_all_again(before, freeze("gcs/link", seconds(20)));
  EXPECT_EQ(estop("on"), 0);
  EXPECT_TRUE(stands());
}

}  // namespace
}  // namespace tocsin
