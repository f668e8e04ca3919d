// SPDX-License-Identifier: Apache-2.0
#include "foundation/parameter_facts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Params {
  double speed_mps = 0.3;
  int pictures = 8;
  bool lit = true;
  std::string name = "a";
  std::string policy = "none";
  std::vector<double> weights{0.5, 0.25};
  std::vector<std::string> topics{"x"};
  template <class Visitor>
  void visit(Visitor& v) {
    live(v)("speed_mps", speed_mps, {0, 1}, "[m/s] of the mission");
    v("pictures", pictures, {1, 30}, "[1/s] rate");
    v("lit", lit, "lamp");
    v("name", name, "of it");
    live(v)("policy", policy, {"none", "tocp"}, "that decides");
    v("weights", weights, {0, 1}, "[1] of terms");
    v("topics", topics, "that are read");
  }
};

TEST(ParameterFactsTest, TellValueRangeTextAndWhetherItIsLive) {
  Params params;
  params.speed_mps = 0.5;
  const auto facts = parameter_facts(params);
  ASSERT_EQ(facts.size(), 7U);
  EXPECT_EQ(facts[0].name, "speed_mps");
  EXPECT_EQ(facts[0].value, ParameterValue(0.5));
  EXPECT_EQ(facts[0].text, "[m/s] of the mission");
  EXPECT_EQ(facts[0].range->max, 1);
  EXPECT_TRUE(facts[0].live);
  EXPECT_EQ(facts[1].value, ParameterValue(std::int64_t{8}));
  EXPECT_FALSE(facts[1].live);
  EXPECT_EQ(facts[2].value, ParameterValue(true));
  EXPECT_FALSE(facts[2].range);
  EXPECT_EQ(facts[3].value, ParameterValue(std::string("a")));
  EXPECT_THAT(facts[3].choices, IsEmpty());
  EXPECT_THAT(facts[4].choices, ElementsAre("none", "tocp"));
  EXPECT_TRUE(facts[4].live);
  EXPECT_EQ(facts[5].value, ParameterValue(std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(facts[6].value, ParameterValue(std::vector<std::string>{"x"}));
}

TEST(ParameterFactsTest, OthersWhoVisitNeedNotKnowOfLiveOnes) {
  const auto params = load_parameters<Params>(YAML::Node(), "sut", {});
  EXPECT_EQ(params.speed_mps, 0.3);
}

TEST(ParameterFactsTest, TheDefaultsSayWhichAreLive) {
  const std::string yaml = default_yaml<Params>();
  EXPECT_THAT(yaml, HasSubstr("speed_mps: 0.3  # [m/s] of the mission; range [0, 1]; live\n"));
  EXPECT_THAT(yaml, HasSubstr("pictures: 8  # [1/s] rate; range [1, 30]\n"));
}

}  // namespace
}  // namespace tocsin
