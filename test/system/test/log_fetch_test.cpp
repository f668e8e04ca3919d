// SPDX-License-Identifier: Apache-2.0
// What the vehicle has logged and never sent, fetched over the emulated radio.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <string>

#include "bag/bag_reader.hpp"
#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

class LogFetchTest : public ::testing::Test {
 protected:
  [[nodiscard]] static Ended log(const Stack& stack, const std::string& arguments) {
    const auto [verb, rest] = std::pair(arguments.substr(0, arguments.find(' ')),
                                        arguments.substr(arguments.find(' ') + 1));
    return run_to_end(Stack::program("tocsin-log"),
                      fmt::format("{} --run-dir {} --host gcs {}", verb, stack.folder(), rest));
  }
  [[nodiscard]] std::string fetch(const std::string& range, const std::string& bag) const {
    return fmt::format("fetch --topic /odom {} -o {}", range, folder_.path(bag));
  }
  TemporaryFolder folder_;
  const std::string bringup_ = standing(folder_.path(), "extends: traffic_log.yaml\n");
};

TEST_F(LogFetchTest, WhatWasNeverSentCrossesOnceAlsoWhenTheVehiclesRouterIsKilled) {
  const Stack stack({bringup_, "--seed", "1"});
  const auto has_log = [&] {
    const Ended list = log(stack, "list --spin-time 2");
    return list.code == 0 && list.output.find("odom") != std::string::npos;
  };
  ASSERT_TRUE(Stack::eventually(seconds(60), has_log)) << stack.output();

  const Ended first = log(stack, fetch("--from -3", "first"));
  ASSERT_EQ(first.code, 0) << first.output << stack.output();
  const bag::BagReader bag(folder_.path("first"));
  ASSERT_EQ(bag.topics().size(), 1U);
  EXPECT_EQ(bag.topics()[0].topic.name, "/odom");
  EXPECT_EQ(bag.topics()[0].topic.type, "nav_msgs/msg/Odometry");
  EXPECT_GT(bag.about().count, 20U) << first.output;

  const pid_t killed = stack.pid("uxv/link");
  ASSERT_EQ(kill(killed, SIGKILL), 0);
  const auto is_back = [&] {
    return stack.pid("uxv/link") != 0 && stack.pid("uxv/link") != killed;
  };
  ASSERT_TRUE(Stack::eventually(seconds(60), is_back)) << stack.output();
  ASSERT_TRUE(Stack::eventually(seconds(60), has_log)) << stack.output();
  const double begin_s = static_cast<double>(bag.about().start_ns) * 1e-9;
  const double length_s = static_cast<double>(bag.about().duration_ns) * 1e-9;
  const Ended again =
      log(stack,
          fetch(fmt::format("--from {:.3f} --to {:.3f}", begin_s + 0.1, begin_s + length_s - 0.1),
                "again"));
  EXPECT_EQ(again.code, 0) << again.output << stack.output();
  EXPECT_THAT(again.output, HasSubstr("Nothing in that time is logged that has not crossed"));
}

TEST_F(LogFetchTest, ATopicThatNobodyLogsIsNamedWithThoseThatThereAre) {
  const Ended nobody = run_to_end(Stack::program("tocsin-log"),
                                  "fetch --topic odom --from -3 --domain 219 --spin-time 0.2");
  EXPECT_EQ(nobody.code, 1);
  EXPECT_THAT(nobody.output, HasSubstr("--topic: odom is in no log that is heard of"));
}

}  // namespace
}  // namespace tocsin
