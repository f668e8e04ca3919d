// SPDX-License-Identifier: Apache-2.0
#include "qos_options.hpp"

#include <CLI/CLI.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;

struct Parsed {
  std::string verb;
  Options options;
};

/// Throws CLI::ParseError.
Parsed parse(std::vector<std::string> words) {
  Parsed parsed;
  CLI::App app;
  Verbs verbs(app);
  declare(verbs, parsed.options);
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
                                             {"lint", "--outage", "-1"},
                                             {"match", "a", "--domain", "300"}}) {
    EXPECT_TRUE(is_refused(words)) << ::testing::PrintToString(words);
  }
}

TEST(QosOptions, OptionsAreTaken) {
  const Options lint =
      parse({"lint", "--direct", "--stream", "a", "--stream", "b", "--outage", "30",
             "--synchronised-clocks", "--json", "--traffic", "t.yaml", "--file", "q.yaml"})
          .options;
  EXPECT_TRUE(lint.direct);
  EXPECT_TRUE(lint.json);
  EXPECT_TRUE(lint.clocks_are_synchronised);
  EXPECT_THAT(lint.streams, ElementsAre("a", "b"));
  EXPECT_EQ(lint.outage_s, 30);
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
