// SPDX-License-Identifier: Apache-2.0
#include "policy_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

ControllerParameters run_with(const std::string& yaml) {
  return {"run/deployment.yaml", {Role::uxv}, std::make_shared<const YAML::Node>(YAML::Load(yaml))};
}

std::string error_of(const PolicyRequest& request) {
  try {
    (void)load_settings(request);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PolicySettings, AreTheDefaultsWithoutSources) {
  const PolicySettings sut = load_settings({});
  EXPECT_EQ(sut.params.alpha, decision::PolicyParams{}.alpha);
  EXPECT_EQ(to_text(sut), "all parameters are the defaults\n");
}

TEST(PolicySettings, TakeWhatARunHadAndLeaveItsOtherParametersAlone) {
  const PolicySettings sut =
      load_settings({run_with("{good_mean: 77.5, silence_is_poor: true}"), "", {}, ""});
  EXPECT_EQ(sut.params.good_mean, 77.5);
  EXPECT_EQ(to_text(sut),
            "parameters from run/deployment.yaml, transmission_controller of uxv: good_mean 77.5\n"
            "all other parameters are the defaults\n");
}

TEST(PolicySettings, LaterSourcesCountMore) {
  const TemporaryFolder folder;
  const std::string model = folder.write("m.yaml", "{alpha: 2, good_mean: 70}");
  const PolicySettings sut =
      load_settings({run_with("{alpha: 1, good_mean: 60, bad_mean: 20, policy: threshold}"),
                     model,
                     {"alpha=3"},
                     "tocp"});
  EXPECT_EQ(sut.params.bad_mean, 20);
  EXPECT_EQ(sut.params.good_mean, 70);
  EXPECT_EQ(sut.params.alpha, 3);
  EXPECT_EQ(sut.params.policy, decision::PolicyKind::tocp);
  EXPECT_EQ(sut.sources.size(), 4U);
}

TEST(PolicySettings, ALawOfMeanAndDeviationReplacesAFamilyOfAnEarlierSource) {
  const auto run =
      run_with("{good_family: beta, good_parameters: [10, 2], false_alarm_samples: 9}");
  EXPECT_EQ(load_settings({run, "", {"bad_mean=30"}, ""}).params.good_family, "beta");
  const auto sut = load_settings({run, "", {"good_mean=80"}, ""}).params;
  EXPECT_EQ(sut.good_family, "normal");
  EXPECT_TRUE(sut.good_parameters.empty());
}

TEST(PolicySettings, AThresholdReplacesARunLengthOfAnEarlierSource) {
  const auto run = run_with("{false_alarm_samples: 900, false_resume_samples: 800}");
  const auto forward = load_settings({run, "", {"alpha=3"}, ""}).params;
  EXPECT_EQ(forward.false_alarm_samples, 0);
  EXPECT_EQ(forward.false_resume_samples, 800);
  const auto reverse = load_settings({run, "", {"reverse_alpha=3"}, ""}).params;
  EXPECT_EQ(reverse.false_alarm_samples, 900);
  EXPECT_EQ(reverse.false_resume_samples, 0);
}

TEST(PolicySettings, AThresholdOfAnEarlierDetectorGivesWayToAlphaAndToARunLength) {
  const auto run = run_with("{detector: focus, detector_threshold: 12}");
  EXPECT_EQ(load_settings({run, "", {"bad_mean=30"}, ""}).params.detector_threshold, 12);
  EXPECT_EQ(load_settings({run, "", {"alpha=3"}, ""}).params.detector_threshold, 0);
  EXPECT_EQ(load_settings({run, "", {"false_alarm_samples=900"}, ""}).params.detector_threshold, 0);
  const auto both = load_settings({run, "", {"alpha=3", "detector_threshold=9"}, ""}).params;
  EXPECT_EQ(both.detector_threshold, 9);
}

TEST(PolicySettings, ARunWhoseControllerNamesNoParameterHasTheDefaults) {
  const YAML::Node controller = YAML::Load("{component: transmission_controller}");
  const ControllerParameters run{"run/deployment.yaml",
                                 {Role::gcs},
                                 std::make_shared<const YAML::Node>(controller["parameters"])};
  const PolicySettings sut = load_settings({run, "", {"alpha=3"}, ""});
  EXPECT_EQ(sut.params.alpha, 3);
  EXPECT_THAT(to_text(sut), HasSubstr("transmission_controller of gcs: none\n"));
}

TEST(PolicySettings, AKeyThatIsSetTwiceHasItsLastValue) {
  const PolicySettings sut = load_settings({{}, "", {"alpha=1", "bad_mean=20", "alpha=2"}, ""});
  EXPECT_EQ(sut.params.alpha, 2);
  EXPECT_THAT(to_text(sut), HasSubstr("parameters from --set: "));
  EXPECT_THAT(to_text(sut), ::testing::Not(HasSubstr("alpha 1")));
}

TEST(PolicySettings, TakeListsAndWordsByOption) {
  const auto sut =
      load_settings({{}, "", {"good_family=beta", "good_parameters=[10, 2]"}, ""}).params;
  EXPECT_EQ(sut.good_family, "beta");
  EXPECT_EQ(sut.good_parameters, (std::vector<double>{10, 2}));
}

TEST(PolicySettings, KnowWhetherSomebodyNamedThePolicy) {
  EXPECT_FALSE(names_policy(load_settings({})));
  EXPECT_FALSE(names_policy(load_settings({{}, "", {"alpha=1"}, ""})));
  EXPECT_TRUE(names_policy(load_settings({{}, "", {"policy=tocp"}, ""})));
  EXPECT_TRUE(names_policy(load_settings({run_with("{policy: none}"), "", {}, ""})));
  const PolicySettings oracle = load_settings({{}, "", {}, "oracle"});
  EXPECT_TRUE(names_policy(oracle));
  EXPECT_EQ(oracle.params.policy, decision::PolicyKind::none) << "it is no policy of a vehicle";
}

TEST(PolicySettings, NameAllTheirSourcesForAnErrorAcrossThem) {
  EXPECT_EQ(source_names(load_settings({})), "the defaults");
  EXPECT_EQ(source_names(load_settings({run_with("{alpha: 1}"), "", {"alpha=2"}, "tocp"})),
            "run/deployment.yaml, transmission_controller of uxv, --set, --policy");
}

TEST(PolicySettings, NameTheSourceOfEveryMistake) {
  const TemporaryFolder folder;
  const std::string model = folder.write("m.yaml", "\nalpha: -1\n");
  EXPECT_THAT(error_of({run_with("{alpha: soon}"), "", {}, ""}), HasSubstr("run/deployment.yaml"));
  EXPECT_THAT(error_of({{}, model, {}, ""}), HasSubstr("m.yaml:2"));
  EXPECT_THAT(error_of({{}, "", {"alpha=-1"}, ""}), HasSubstr("--set"));
  EXPECT_THAT(error_of({{}, "", {"alfa=1"}, ""}), HasSubstr("policy.alfa"));
  EXPECT_THAT(error_of({{}, "", {"alpha"}, ""}), HasSubstr("must be key=value"));
  EXPECT_THAT(error_of({{}, "", {"alpha=[1"}, ""}), HasSubstr("not valid YAML"));
  EXPECT_THAT(error_of({{}, "", {"=3"}, ""}), HasSubstr("--set: '=3' must be key=value"));
  EXPECT_THAT(error_of({{}, "", {"alpha="}, ""}), HasSubstr("policy.alpha"));
  EXPECT_THAT(error_of({{}, "", {"policy=magic"}, ""}), HasSubstr("'magic' is not one of"));
  const std::string list = folder.write("list.yaml", "[alpha, 1]");
  EXPECT_THAT(error_of({{}, list, {}, ""}), HasSubstr("must be a map of parameters"));
  EXPECT_THAT(error_of({{}, "/nonexistent.yaml", {}, ""}), HasSubstr("/nonexistent.yaml"));
}

}  // namespace
}  // namespace tocsin::tools
