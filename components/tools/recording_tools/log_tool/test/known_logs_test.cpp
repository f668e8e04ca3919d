// SPDX-License-Identifier: Apache-2.0
#include "known_logs.hpp"

#include <gmock/gmock.h>

#include "foundation/error.hpp"

namespace tocsin::log_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Time t0{std::chrono::hours(1)};
constexpr std::int64_t second_ns = 1'000'000'000;

/// Of a vehicle whose clock stands at 1000 s.
tocsin_msgs::msg::LinkState state(const std::vector<std::string>& topics,
                                  const char* role = "uxv") {
  tocsin_msgs::msg::LinkState state;
  state.role(role);
  state.stamp().sec(1000);
  for (const std::string& name : topics) {
    tocsin_msgs::msg::LoggedTopic topic;
    topic.topic(name);
    topic.samples(42);
    topic.first_ns(400 * second_ns);
    topic.last_ns(999 * second_ns);
    state.logged().push_back(topic);
  }
  return state;
}

TEST(KnownLogs, KnowWhatRoutersTell) {
  KnownLogs sut;
  EXPECT_FALSE(sut.any());
  sut.on_state(state({}), t0);
  EXPECT_FALSE(sut.any()) << "a router without a log";
  sut.on_state(state({"odom", "camera"}), t0);
  sut.on_state(state({"map"}, "gcs"), t0);
  EXPECT_TRUE(sut.any());
  EXPECT_TRUE(sut.has("camera"));
  EXPECT_FALSE(sut.has("scan"));
  EXPECT_THAT(sut.topics(), ElementsAre("camera", "map", "odom"));
}

TEST(KnownLogs, TheTableTellsAgesByTheLogsClock) {
  KnownLogs sut;
  sut.on_state(state({"odom"}), t0);
  const std::string text = sut.table(t0 + std::chrono::seconds(1));
  EXPECT_THAT(text, HasSubstr("\nodom                                    uxv             42        "
                              " 601.0 s           2.0 s\n"));
}

TEST(KnownLogs, TheNewestWordOfARouterCounts) {
  KnownLogs sut;
  sut.on_state(state({"odom", "camera"}), t0);
  auto later = state({"odom"});
  later.stamp().sec(1010);
  later.logged()[0].samples(50);
  sut.on_state(later, t0 + std::chrono::seconds(10));
  EXPECT_FALSE(sut.has("camera"));
  EXPECT_EQ(sut.clock_ns("odom", t0 + std::chrono::seconds(10)), 1010 * second_ns);
  EXPECT_THAT(sut.table(t0 + std::chrono::seconds(10)), HasSubstr("          50         610.0 s"));
}

TEST(KnownLogs, TellWhetherNobodyLogsOrNothingRuns) {
  KnownLogs sut;
  EXPECT_THAT(sut.why_none(), HasSubstr("nothing runs here: no router was heard"));
  sut.on_state(state({}), t0);
  EXPECT_FALSE(sut.any());
  EXPECT_THAT(sut.why_none(), HasSubstr("no router tells of a log"));
}

TEST(RequestFor, IsUpToNowAtMost) {
  const auto sut = request_for("odom", {"-60", "2000"}, 1000 * second_ns);
  EXPECT_EQ(sut.topic(), "odom");
  EXPECT_EQ(sut.from_ns(), 940 * second_ns);
  EXPECT_EQ(sut.to_ns(), 1000 * second_ns);
  EXPECT_EQ(request_for("odom", {"-60", "-50"}, 1000 * second_ns).to_ns(), 950 * second_ns);
}

TEST(RequestFor, RefusesAPartThatIsEmpty) {
  for (const SaidRange& said : {SaidRange{"-60", "-60"}, {"-10", "-20"}, {"2000", "3000"}}) {
    try {
      (void)request_for("odom", said, 1000 * second_ns);
      ADD_FAILURE() << said.from << " " << said.to;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--from: '" + said.from + "' is not before --to"));
    }
  }
}

}  // namespace
}  // namespace tocsin::log_tool
