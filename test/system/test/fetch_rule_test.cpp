// SPDX-License-Identifier: Apache-2.0
// What a rule fetches around an emergency stop, over the emulated radio, while the router that
// holds its request is killed with -9.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"
#include "stored_topics.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using Id = std::pair<std::uint64_t, std::uint64_t>;  // writer and number

/// Of odom, which the base sends at its full rate and no class of the traffic file has.
struct Window {
  std::int64_t from_ns = 0;  ///< since the Unix epoch
  std::int64_t to_ns = 0;
};

class FetchRuleTest : public ::testing::Test {
 protected:
  FetchRuleTest() {
    bringup_ = standing(folder_.path(),
                        "extends: traffic.yaml\n"
                        "uxv:\n"
                        "  low: {log: [odom]}\n"
                        "  fetch:\n"
                        "    - {when: safety_status, field: emergency_stop, topics: [odom],\n"
                        "       before_s: 5, after_s: 5}\n");
  }
  [[nodiscard]] static Ended estop(const std::string& word) {
    return run_to_end(Stack::program("tocsin-estop"), word);
  }
  /// What the vehicle's router keeps of its request; a second one would be an event too many.
  [[nodiscard]] static std::optional<Window> kept(const Stack& stack) {
    std::ifstream file(stack.path("uxv/store/history/requests"));
    std::uint64_t id = 0;
    Window window;
    std::string rule;
    std::string topic;
    std::string more;
    if (!(file >> id >> window.from_ns >> window.to_ns >> rule >> topic)) return std::nullopt;
    EXPECT_EQ(topic, "odom");
    EXPECT_FALSE(file >> more) << more;
    return window;
  }
  /// In the vehicle's log within the window, in its order.
  [[nodiscard]] static std::vector<Id> logged(const Stack& stack, const Window& window) {
    std::vector<Id> ids;
    for (const LoggedOne& one : logged_in(stack.path("uxv/store/history"), "odom")) {
      const bool is_in = window.from_ns <= one.at_ns && one.at_ns <= window.to_ns;
      if (is_in) ids.emplace_back(one.source, one.sequence);
    }
    return ids;
  }
  static void kill_router(const Stack& stack) {
    const pid_t killed = stack.pid("uxv/link");
    ASSERT_EQ(kill(killed, SIGKILL), 0);
    ASSERT_TRUE(Stack::eventually(seconds(30), [&] {
      const pid_t next = stack.pid("uxv/link");
      return next != 0 && next != killed;
    })) << stack.output();
  }
  TemporaryFolder folder_;
  std::string bringup_;
};

TEST_F(FetchRuleTest, TenSecondsAroundAnEmergencyStopCrossOnceThoughTheRouterIsKilled) {
  // A small share, so that there is time to kill in.
  const Stack stack({bringup_, "--seed", "1", "--set", "link_router.backfill_share=0.05"});
  const auto has_logged = [&] {
    const auto all = logged_in(stack.path("uxv/store/history"), "odom");
    return !all.empty() && all.back().at_ns - all.front().at_ns > 6'000'000'000;
  };
  ASSERT_TRUE(Stack::eventually(seconds(60), has_logged)) << stack.output();
  const StationReaders readers(stack.running("gcs/link"), standing_domain + 1,
                               Stack::share("config/qos.yaml"), {"odom"});
  const Ended on = estop("on");
  ASSERT_EQ(on.code, 0) << on.output;
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] { return kept(stack).has_value(); }))
      << stack.output();
  const Window window = *kept(stack);
  EXPECT_EQ(window.to_ns - window.from_ns, 10'000'000'000);

  kill_router(stack);  // before the end of what is wanted
  const Ended off = estop("off");
  ASSERT_EQ(off.code, 0) << off.output;
  const auto some_came = [&] { return readers.got().size() > 50; };
  ASSERT_TRUE(Stack::eventually(seconds(60), some_came)) << stack.output();
  const auto before = kept(stack);
  ASSERT_TRUE(before) << "all of it has crossed already";
  EXPECT_EQ(before->from_ns, window.from_ns) << "one event";
  kill_router(stack);  // in the middle of it

  ASSERT_TRUE(Stack::eventually(seconds(90), [&] { return !kept(stack); })) << stack.output();
  std::vector<Id> got;
  for (const GotSample& one : readers.got()) {
    EXPECT_TRUE(one.backfilled) << "odom is not sent by itself";
    got.emplace_back(one.source, one.sequence);
  }
  const std::vector<Id> wanted = logged(stack, window);
  EXPECT_GT(wanted.size(), 300U) << "of 50 a second, but for the time in which the router was dead";
  EXPECT_EQ(got, wanted) << "each, once, in order";
}

}  // namespace
}  // namespace tocsin
