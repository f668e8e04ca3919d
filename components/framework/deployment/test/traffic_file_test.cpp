// SPDX-License-Identifier: Apache-2.0
#include "deployment/traffic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class TrafficFileTest : public ::testing::Test {
 protected:
  TrafficFileTest() {
    folder_.write("config/traffic.yaml",
                  "uxv:\n"
                  "  high: {while_poor: send, topics: [location, quality]}\n"
                  "  low: {while_poor: drop, topics: [battery, picture]}\n"
                  "gcs:\n"
                  "  high: {while_poor: send, topics: [goal, picture]}\n");
  }
  void read(const std::string& text) {
    YamlSources sources;
    file_.reset(read_traffic_file(folder_.write("own.yaml", text), folder_.path(), sources));
  }
  [[nodiscard]] std::vector<std::string> topics(const std::string& role,
                                                const std::string& name) const {
    return file_[role][name]["topics"].as<std::vector<std::string>>();
  }
  const TemporaryFolder folder_;
  YAML::Node file_;
};

TEST_F(TrafficFileTest, ANamedTopicComesToItsClassAndLeavesTheOtherOfItsRole) {
  read("extends: traffic.yaml\nuxv: {high: {topics: [picture, scan]}}");
  EXPECT_THAT(topics("uxv", "high"), ElementsAre("location", "quality", "picture", "scan"));
  EXPECT_THAT(topics("uxv", "low"), ElementsAre("battery"));
  EXPECT_THAT(topics("gcs", "high"), ElementsAre("goal", "picture"));
}

TEST_F(TrafficFileTest, ServicesAndActionsMoveAsTopicsDo) {
  folder_.write("config/traffic.yaml",
                "uxv:\n  high: {services: [dock, map], actions: [drive]}\n"
                "  low: {topics: [dock]}\n");
  read("extends: traffic.yaml\nuxv: {low: {services: [dock, lamp], actions: [drive]}}");
  EXPECT_THAT(file_["uxv"]["high"]["services"].as<std::vector<std::string>>(), ElementsAre("map"));
  EXPECT_THAT(file_["uxv"]["high"]["actions"].as<std::vector<std::string>>(), IsEmpty());
  EXPECT_THAT(file_["uxv"]["low"]["services"].as<std::vector<std::string>>(),
              ElementsAre("dock", "lamp"));
  EXPECT_THAT(topics("uxv", "low"), ElementsAre("dock")) << "a topic of that name is another thing";
}

TEST_F(TrafficFileTest, ANewClassTakesItsTopicsFromTheOthers) {
  read("extends: traffic.yaml\nuxv: {normal: {while_poor: drop, topics: [battery, picture]}}");
  EXPECT_THAT(topics("uxv", "low"), IsEmpty());
  EXPECT_THAT(topics("uxv", "normal"), ElementsAre("battery", "picture"));
}

TEST_F(TrafficFileTest, ListsThatTheBaseSharesAreChangedForOneRoleOnly) {
  folder_.write("config/traffic.yaml",
                "uxv: {low: {topics: &all [a, b]}}\ngcs: {low: {topics: *all}}\n");
  read("extends: traffic.yaml\nuxv: {high: {topics: [a]}}");
  EXPECT_THAT(topics("uxv", "low"), ElementsAre("b"));
  EXPECT_THAT(topics("gcs", "low"), ElementsAre("a", "b"));
}

TEST_F(TrafficFileTest, WhatIsNoMapOfClassesStaysForTheReaderToRefuse) {
  read("extends: traffic.yaml\nuxv: 3\ngcs: {high: [goal]}");
  EXPECT_EQ(file_["uxv"].Scalar(), "3");
  EXPECT_TRUE(file_["gcs"]["high"].IsSequence());
}

}  // namespace
}  // namespace tocsin::deployment
