// SPDX-License-Identifier: Apache-2.0
#include "foundation/parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Params {
  double lost_after_s = 1.0;
  int attempts = 3;
  bool enabled = true;
  std::string name = "uxv";
  std::string policy = "none";
  std::vector<double> weights{0.4, 0.6};
  std::vector<std::string> topics;
  template <class Visitor>
  void visit(Visitor& v) {
    v("lost_after_s", lost_after_s, {0.05, 60}, "[s] longer silence is lost");
    v("attempts", attempts, {1, 9}, "[1] tries");
    v("enabled", enabled, "whether it runs");
    v("name", name, "its name");
    v("policy", policy, {"none", "tocp"}, "who decides");
    v("weights", weights, {0, 1}, "[1] weights");
    v("topics", topics, "names");
  }
};

Params load(const std::string& yaml) {
  return load_parameters<Params>(YAML::Load(yaml), "monitor", "file.yaml");
}

std::string error_of(const std::string& yaml) {
  try {
    (void)load(yaml);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Parameters, KeepDefaultsForAbsentKeys) {
  const Params sut = load("attempts: 5");
  EXPECT_EQ(sut.attempts, 5);
  EXPECT_EQ(sut.lost_after_s, 1.0);
  EXPECT_EQ(load("").attempts, 3);
}

TEST(Parameters, ReadEveryKind) {
  const Params sut = load(
      "{lost_after_s: 0.05, enabled: false, name: x, policy: tocp, weights: [0, 1], topics: [a]}");
  EXPECT_EQ(sut.lost_after_s, 0.05);
  EXPECT_FALSE(sut.enabled);
  EXPECT_EQ(sut.name, "x");
  EXPECT_EQ(sut.policy, "tocp");
  EXPECT_EQ(sut.weights, (std::vector<double>{0, 1}));
  EXPECT_EQ(sut.topics, std::vector<std::string>{"a"});
}

TEST(Parameters, RejectNumbersOutsideTheirRange) {
  EXPECT_EQ(error_of("a: 1\nlost_after_s: -1").substr(0, 57),
            "monitor.lost_after_s: -1 is outside [0.05, 60] (file.yaml");
  EXPECT_THAT(error_of("lost_after_s: 60.001"), HasSubstr("60.001 is outside"));
  EXPECT_THAT(error_of("lost_after_s: .nan"), HasSubstr("is outside"));
  EXPECT_THAT(error_of("weights: [2]"), HasSubstr("monitor.weights: 2 is outside [0, 1]"));
  EXPECT_EQ(error_of("lost_after_s: 60"), "no error");
}

TEST(Parameters, RejectWrongTypes) {
  EXPECT_THAT(error_of("lost_after_s: soon"), HasSubstr("'soon' is not a number"));
  EXPECT_THAT(error_of("lost_after_s: [1]"), HasSubstr("is not a number"));
  EXPECT_THAT(error_of("attempts: 1.5"), HasSubstr("1.5 is not a whole number"));
  EXPECT_THAT(error_of("enabled: perhaps"), HasSubstr("neither true nor false"));
  EXPECT_THAT(error_of("name: [a]"), HasSubstr("is not a text"));
  EXPECT_THAT(error_of("weights: 1"), HasSubstr("is not a list of numbers"));
  EXPECT_THAT(error_of("weights: [a]"), HasSubstr("not a number"));
  EXPECT_THAT(error_of("topics: a"), HasSubstr("is not a list of texts"));
  EXPECT_THAT(error_of("[1, 2]"), HasSubstr("monitor: must be a map"));
}

TEST(Parameters, RejectWordsThatAreNotAllowed) {
  EXPECT_THAT(error_of("policy: magic"), HasSubstr("'magic' is not one of: none, tocp"));
}

TEST(Parameters, RejectUnknownKeysWithTheirLine) {
  const std::string text = error_of("attempts: 1\nlost: 1");
  EXPECT_THAT(text, HasSubstr("monitor.lost: unknown key; allowed: [lost_after_s, attempts"));
  EXPECT_THAT(text, HasSubstr("(file.yaml:2)"));
}

TEST(Parameters, AMisspeltKeyOrWordIsShownWithWhatIsLikeIt) {
  EXPECT_THAT(error_of("attemps: 1"), HasSubstr("; did you mean 'attempts'? (file.yaml:1)"));
  EXPECT_THAT(error_of("policy: tcop"), HasSubstr("; did you mean 'tocp'?"));
  EXPECT_THAT(error_of("speed: 1"), Not(HasSubstr("did you mean")));
}

TEST(Parameters, PrintTheirDefaults) {
  const std::string text = default_yaml<Params>();
  EXPECT_THAT(text, HasSubstr("lost_after_s: 1  # [s] longer silence is lost; range [0.05, 60]\n"));
  EXPECT_THAT(text, HasSubstr("policy: none  # who decides; one of none, tocp\n"));
  EXPECT_THAT(text, HasSubstr("weights: [0.4, 0.6]"));
}

TEST(Parameters, PrintedDefaultsLoadAgain) {
  const Params sut = load(default_yaml<Params>());
  EXPECT_EQ(sut.weights, Params().weights);
}

TEST(Parameters, AnErrorOfTheComponentGetsThePlaceOfItsParameter) {
  const YAML::Node node = YAML::Load("lost_after_s: 2\nname: /maps/a.yaml\n");
  EXPECT_EQ(with_place("lost_after_s: 2 is less than retry_s", node, "file.yaml"),
            "lost_after_s: 2 is less than retry_s (file.yaml:1)");
  EXPECT_EQ(with_place("monitor.name: is no map", node, "file.yaml"),
            "monitor.name: is no map (file.yaml:2)");
}

TEST(Parameters, AnErrorAboutAFileGetsThePlaceOfTheParameterThatNamesIt) {
  const YAML::Node node = YAML::Load("a: 1\nname: /maps/a.yaml\n");
  EXPECT_EQ(with_place("/maps/a.yaml: cannot be read", node, "file.yaml"),
            "/maps/a.yaml: cannot be read (name, file.yaml:2)");
}

TEST(Parameters, AnErrorAboutSomethingElseStaysAsItIs) {
  const YAML::Node node = YAML::Load("name: a");
  for (const char* text : {"no device", "map.origin: wrong (a.yaml:3)", "other: 3", ""}) {
    EXPECT_EQ(with_place(text, node, "file.yaml"), text);
  }
  EXPECT_EQ(with_place("name: 3", YAML::Node(), "file.yaml"), "name: 3");
}

}  // namespace
}  // namespace tocsin
