// SPDX-License-Identifier: Apache-2.0
#include "qos_options.hpp"

#include <CLI/CLI.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Parsed {
  std::string verb;
  Options options;
};

/// Throws CLI::ParseError.
Parsed parse(std::vector<std::string> words) {
  Parsed parsed;
  CLI::App app;
  declare(app, parsed.options);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  parsed.verb = app.get_subcommands().front()->get_name();
  return parsed;
}

bool is_refused(const std::vector<std::string>& words) {
  try {
    (void)parse(words);
    return false;
  } catch (const CLI::ParseError&) {
    return true;
  }
}

TEST(QosOptions, TuneTakesAFileAFolderAndJobs) {
  const Parsed plain = parse({"tune", "tune.yaml"});
  EXPECT_EQ(plain.verb, "tune");
  EXPECT_EQ(plain.options.tune.file, "tune.yaml");
  EXPECT_EQ(plain.options.tune.out, "");
  EXPECT_FALSE(plain.options.tune.jobs);
  const Parsed all = parse({"tune", "tune.yaml", "--out", "here", "--jobs", "2"});
  EXPECT_EQ(all.options.tune.out, "here");
  EXPECT_EQ(all.options.tune.jobs, 2);
  EXPECT_TRUE(is_refused({"tune"}));
  EXPECT_TRUE(is_refused({"tune", "tune.yaml", "--jobs", "0"}));
}

TEST(QosOptions, EveryVerbTakesItsNames) {
  EXPECT_EQ(parse({"list"}).verb, "list");
  EXPECT_EQ(parse({"show", "sensor"}).options.one, "sensor");
  EXPECT_EQ(parse({"explain", "sensor"}).options.one, "sensor");
  EXPECT_EQ(parse({"diff", "a", "b"}).options.other, "b");
  EXPECT_EQ(parse({"match", "a"}).options.other, "");
  EXPECT_EQ(parse({"match", "a", "/b"}).options.other, "/b");
  EXPECT_EQ(parse({"lint"}).verb, "lint");
  EXPECT_THAT(parse({"export"}).options.profiles, IsEmpty());
  EXPECT_THAT(parse({"export", "a", "b"}).options.profiles, ElementsAre("a", "b"));
  EXPECT_THAT(parse({"set", "/odom", "deadline_s=1", "lifespan_s=2"}).options.settings,
              ElementsAre("deadline_s=1", "lifespan_s=2"));
}

TEST(QosOptions, WhatIsMissingOrUnknownIsRefused) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"dance"},
                                             {"show"},
                                             {"diff", "a"},
                                             {"set", "/odom"},
                                             {"lint", "f.xml"},
                                             {"list", "sensor"},
                                             {"export", "--to", "rti"},
                                             {"lint", "--mtu", "100"},
                                             {"lint", "--outage", "-1"},
                                             {"match", "a", "--domain", "300"}}) {
    EXPECT_TRUE(is_refused(words)) << ::testing::PrintToString(words);
  }
}

TEST(QosOptions, WhatIsNotSaidHasItsDefault) {
  const Options options = parse({"lint"}).options;
  EXPECT_FALSE(options.json);
  EXPECT_FALSE(options.direct);
  EXPECT_FALSE(options.clocks_are_synchronised);
  EXPECT_EQ(options.outage_s, 10);
  EXPECT_EQ(options.mtu_bytes, 1500);
  EXPECT_EQ(options.file, "");
  EXPECT_EQ(parse({"export"}).options.vendor, "fastdds");
  EXPECT_EQ(parse({"set", "/odom", "deadline_s=1"}).options.spin_s, 2);
}

TEST(QosOptions, OptionsAreTaken) {
  const Options lint =
      parse({"lint", "--direct", "--stream", "a", "--stream", "b", "--outage", "30", "--mtu",
             "1400", "--synchronised-clocks", "--json", "--traffic", "t.yaml", "--file", "q.yaml"})
          .options;
  EXPECT_TRUE(lint.direct);
  EXPECT_TRUE(lint.json);
  EXPECT_TRUE(lint.clocks_are_synchronised);
  EXPECT_THAT(lint.streams, ElementsAre("a", "b"));
  EXPECT_EQ(lint.outage_s, 30);
  EXPECT_EQ(lint.mtu_bytes, 1400);
  EXPECT_EQ(lint.traffic, "t.yaml");
  EXPECT_EQ(lint.file, "q.yaml");
  const Options set = parse({"set", "/odom", "deadline_s=1", "--domain", "7", "--spin-time", "0.5",
                             "--host", "gcs", "--json"})
                          .options;
  EXPECT_EQ(set.host.domain, 7);
  EXPECT_EQ(set.host.host, "gcs");
  EXPECT_EQ(set.spin_s, 0.5);
  EXPECT_TRUE(set.json);
  EXPECT_TRUE(parse({"show", "sensor", "--all"}).options.all);
  EXPECT_TRUE(parse({"match", "a", "--all"}).options.all);
  EXPECT_EQ(parse({"export", "--to", "cyclone"}).options.vendor, "cyclone");
}

}  // namespace
}  // namespace tocsin::qos_tool
