// SPDX-License-Identifier: Apache-2.0
#include "topic_options.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace tocsin::topic_tool {
namespace {

/// What a command line means.
struct Parsed {
  explicit Parsed(const std::string& line) {
    declare(verbs, options);
    try {
      app.parse(line);
    } catch (const CLI::ParseError& error) {
      refused = error.what();
    }
  }
  CLI::App app{"test"};
  Verbs verbs{app};
  Options options;
  std::string refused;
};

TEST(TopicOptions, OfEchoMayNameAPlaceInTheLog) {
  EXPECT_FALSE(Parsed("echo /x").options.log.is_wanted());
  const Parsed last("echo /x --last 10 --consumer plot --log /var/log");
  EXPECT_EQ(last.refused, "");
  EXPECT_TRUE(last.options.log.is_wanted());
  EXPECT_EQ(last.options.log.last, 10U);
  EXPECT_EQ(last.options.log.consumer, "plot");
  EXPECT_EQ(last.options.log.folder, "/var/log");
  EXPECT_EQ(Parsed("echo /x --since 2.5").options.log.since_s, 2.5);
  EXPECT_TRUE(Parsed("echo /x --from-start").options.log.from_start);
  for (const char* const line : {"--last 3 --since 4", "--last 3 --from-start",
                                 "--since 3 --from-start", "--last -1", "--since -1"}) {
    EXPECT_FALSE(Parsed(std::string("echo /x ") + line).refused.empty()) << line;
  }
}

TEST(TopicOptions, OfPubAreThoseOfRos2) {
  const Parsed sut("pub /x std_msgs/msg/String \"{data: hi}\" -r 5 -t 3 -w 2");
  EXPECT_EQ(sut.refused, "");
  EXPECT_EQ(sut.options.type, "std_msgs/msg/String");
  EXPECT_EQ(sut.options.message, "{data: hi}");
  EXPECT_EQ(sut.options.rate_hz, 5);
  EXPECT_EQ(sut.options.times, 3);
  EXPECT_EQ(sut.options.wait_readers, 2);
  EXPECT_EQ(sut.options.reliability, Reliability::reliable);
  EXPECT_EQ(sut.options.durability, Durability::volatile_kind);
  EXPECT_EQ(Parsed("pub /x a/b --qos-durability transient_local").options.durability,
            Durability::transient_local);
  EXPECT_EQ(Parsed("pub /x a/b --qos-reliability best_effort").options.reliability,
            Reliability::best_effort);
  EXPECT_FALSE(Parsed("pub /x a/b").options.wait_readers.has_value());
  EXPECT_FALSE(Parsed("pub /x a/b --qos-durability persistent").refused.empty()) << "not offered";
  EXPECT_FALSE(Parsed("pub /x").refused.empty()) << "without a type";
  EXPECT_FALSE(Parsed("pub /x a/b -1 -t 3").refused.empty()) << "once and three times";
  EXPECT_FALSE(Parsed("pub /x a/b -r 0").refused.empty());
  EXPECT_FALSE(Parsed("pub /x a/b -t 0").refused.empty());
  EXPECT_FALSE(Parsed("pub /x a/b --qos-reliability sure").refused.empty());
}

TEST(TopicOptions, AWindowHoldsTwoSamplesAtLeast) {
  EXPECT_EQ(Parsed("hz /x -w 2").options.window, 2U);
  EXPECT_EQ(Parsed("bw /x").options.window, 10'000U);
  EXPECT_FALSE(Parsed("hz /x -w 1").refused.empty());
}

}  // namespace
}  // namespace tocsin::topic_tool
