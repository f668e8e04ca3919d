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

TEST(ShapeOptions, AreReliableVolatileAndTheLastSampleUnlessTold) {
  const auto sut = parse("-P -t Square");
  EXPECT_TRUE(sut->publish);
  EXPECT_EQ(sut->topic, "Square");
  EXPECT_EQ(sut->color, "BLUE");
  EXPECT_EQ(sut->shapesize, 20);
  EXPECT_EQ(sut->write_period_s, 0.033);
  EXPECT_EQ(sut->read_period_s, 0.1);
  EXPECT_TRUE(sut->qos.reliable());
  EXPECT_EQ(sut->qos.durability, Durability::volatile_kind);
  EXPECT_EQ(sut->qos.depth, 1);
  EXPECT_FALSE(sut->qos.exclusive());
  EXPECT_EQ(sut->unsupported, "");
  EXPECT_EQ(parse("-S -t Square")->color, "") << "a subscriber's colour is a filter";
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

TEST(ShapeOptions, WhatThePublisherWrites) {
  const auto sut = parse(
      "-P -t Square -c RED -z 0 --size-modulo 50 --num-instances 4 --num-topics 3 "
      "--num-iterations 200 --final-instance-state d --additional-payload-size 9 "
      "--write-period 100 -w");
  EXPECT_EQ(sut->color, "RED");
  EXPECT_EQ(sut->shapesize, 0);
  EXPECT_EQ(sut->size_modulo, 50);
  EXPECT_EQ(sut->instances, 4);
  EXPECT_EQ(sut->topics, 3);
  EXPECT_EQ(sut->iterations, 200);
  EXPECT_EQ(sut->final_state, FinalState::dispose);
  EXPECT_EQ(sut->payload_bytes, 9);
  EXPECT_EQ(sut->write_period_s, 0.1);
  EXPECT_TRUE(sut->print_written);
  EXPECT_EQ(parse("-P -t Square --final-instance-state u")->final_state, FinalState::unregister);
}

TEST(ShapeOptions, OfTwoTheLastCounts) {
  EXPECT_EQ(parse("-P -t Square -k 3 -k 5")->qos.depth, 5);
  EXPECT_EQ(parse("-P -t Square -t Circle")->topic, "Circle");
  EXPECT_EQ(parse("-P -t Square -d 1 -d 2")->domain, 2);
}

TEST(ShapeOptions, HelpIsNoCommandLineOfACase) {
  EXPECT_FALSE(parse("--help").has_value());
  EXPECT_FALSE(parse("-h -P -t Square").has_value());
}

TEST(ShapeOptions, ReliableWinsOverBestEffort) {
  EXPECT_TRUE(parse("-P -t Square -b -r")->qos.reliable());
}

TEST(ShapeOptions, WhatASubscriberAsksFor) {
  const auto sut = parse("-S -t Square -c RED -R --read-period 200 --take-read -v d");
  EXPECT_FALSE(sut->publish);
  EXPECT_EQ(sut->color, "RED");
  EXPECT_TRUE(sut->reads);
  EXPECT_EQ(sut->read_period_s, 0.2);
  EXPECT_EQ(sut->filter, "");
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
