// SPDX-License-Identifier: Apache-2.0
// The command lines of the suite's cases.
#include "shapes/shape_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::shapes {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::optional<ShapeOptions> parse(const std::string& line) {
  std::istringstream text("shapes " + line);
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_options(static_cast<int>(argv.size()), argv.data());
}

std::string refused(const std::string& line) {
  try {
    (void)parse(line);
    return "";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(ShapeOptions, EveryPolicyOfTheSuite) {
  const auto sut = parse("-P -t Square -b -k 5 -f 3000 -s 4 -p p1 --lifespan 250 -d 3");
  EXPECT_FALSE(sut->qos.reliable());
  EXPECT_EQ(sut->qos.depth, 5);
  EXPECT_EQ(sut->qos.deadline_s, 3);
  EXPECT_TRUE(sut->qos.exclusive());
  EXPECT_EQ(sut->qos.ownership_strength, 4);
  EXPECT_THAT(sut->qos.partition, ElementsAre("p1"));
  EXPECT_EQ(sut->qos.lifespan_s, 0.25);
  EXPECT_EQ(sut->domain, 3);
  EXPECT_TRUE(parse("-P -t Square -k 0")->qos.keeps_all());
  EXPECT_FALSE(parse("-P -t Square -s -1")->qos.exclusive());
  EXPECT_TRUE(parse("-S -t Square -D l")->qos.keeps_last());
  EXPECT_EQ(parse("-S -t Square --time-filter 1000")->qos.minimum_separation_s, 1);
}

TEST(ShapeOptions, WhatFastDdsDoesNotHaveIsNamed) {
  EXPECT_EQ(parse("-P -t Square -x 2")->unsupported, "Data Representation XCDR2");
  EXPECT_EQ(parse("-P -t Square -x 1")->unsupported, "");
  EXPECT_EQ(parse("-S -t Square -D t")->unsupported, "Durability TRANSIENT");
  EXPECT_EQ(parse("-S -t Square -D p")->unsupported, "Durability PERSISTENT");
  EXPECT_EQ(parse("-S -t Square --ordered --access-scope t --take-read")->unsupported,
            "Presentation Ordered Access");
  EXPECT_EQ(parse("-P -t Square --coherent --coherent-sample-count 3")->unsupported,
            "Presentation Coherent Access");
}

TEST(ShapeOptions, RefusesWhatShapeMainRefuses) {
  EXPECT_THAT(refused("-P"), HasSubstr("-t"));
  EXPECT_THAT(refused("-t Square"), HasSubstr("publish [-P] or subscribe [-S]"));
  EXPECT_THAT(refused("-P -S -t Square"), HasSubstr("publish [-P] or subscribe [-S]"));
  EXPECT_THAT(refused("-S -t Square -c RED --cft x"), HasSubstr("both --cft and -c"));
  for (const char* wrong : {"-k -1", "-k x", "-f -1", "-s -2", "-D x", "-x 3", "--num-instances 0",
                            "--final-instance-state x", "--coherent-sample-count 1", "--dance"}) {
    EXPECT_NE(refused(std::string("-P -t Square ") + wrong), "") << wrong;
  }
}

}  // namespace
}  // namespace tocsin::shapes
