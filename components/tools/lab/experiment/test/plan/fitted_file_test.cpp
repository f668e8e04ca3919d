// SPDX-License-Identifier: Apache-2.0
#include "plan/fitted_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

Fitted example() {
  return {{"a", {{every_policy, {"good_mean=80"}}, {"tocp", {"alpha=3", "fixed_pause_samples=7"}}}},
          {"b", {{"tocp", {"alpha=9"}}}}};
}

std::string error_of_file(const std::string& text) {
  const TemporaryFolder folder;
  return error_of([&] { (void)load_fitted(folder.write("fitted.yaml", text)); });
}

TEST(SettingsFor, PutWhatIsCommonBeforeWhatIsThePolicys) {
  EXPECT_THAT(settings_for(example(), "a", "tocp"),
              ElementsAre("good_mean=80", "alpha=3", "fixed_pause_samples=7"));
  EXPECT_THAT(settings_for(example(), "a", "none"), ElementsAre("good_mean=80"));
}

TEST(SettingsFor, AreNoneForWhatWasNotFitted) {
  EXPECT_THAT(settings_for(example(), "c", "tocp"), IsEmpty());
  EXPECT_THAT(settings_for(example(), "b", "belief"), IsEmpty());
}

TEST(FittedFile, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const std::string text = fitted_text(example(), "By a test.\nIn two lines.");
  EXPECT_THAT(text, StartsWith("# SPDX-License-Identifier: Apache-2.0\n# By a test.\n# In two"));
  EXPECT_EQ(load_fitted(folder.write("fitted.yaml", text)), example());
}

TEST(FittedFile, NamesWhatIsWrongAndItsLine) {
  EXPECT_THAT(error_of_file("- a\n"), HasSubstr("is not a map of missions"));
  EXPECT_THAT(error_of_file("a: 3\n"), HasSubstr("fitted.a: is not a map of policies"));
  EXPECT_THAT(error_of_file("a:\n  tocp: alpha=3\n"), HasSubstr("fitted.a.tocp: is not a list"));
  const std::string entry = error_of_file("a:\n  tocp: [alpha=3,\n    alpha]\n");
  EXPECT_THAT(entry, HasSubstr("an entry that is not key=value"));
  EXPECT_THAT(entry, HasSubstr("fitted.yaml:3"));
}

TEST(FittedFile, IsReadWithTheExperimentThatNamesIt) {
  const ToyExperiment toy(std::string("fitted: sub/fitted.yaml\n") + toy_text);
  EXPECT_THAT(error_of([&] { (void)toy.load(); }), HasSubstr("`tocsin experiment fit"));
  EXPECT_THAT(load_unfitted(toy.path("toy.yaml")).fitted, IsEmpty());
  toy.write("sub/fitted.yaml", fitted_text(example(), ""));
  EXPECT_EQ(toy.load().fitted, example());
}

TEST(FittedFile, StandsBelowWhatThePolicyItselfSets) {
  const ToyExperiment toy(std::string("fitted: fitted.yaml\n") + toy_text);
  toy.write("fitted.yaml", "a: {every_policy: [alpha=1], tocp_dsp: [alpha=2]}\n");
  const Experiment experiment = toy.load();
  const auto plan = make_plan(experiment);
  const auto sut = overrides_of(plan[3], experiment.timing, "/share", "/out").set;
  const auto place = [&](const std::string& text) {
    return std::find(sut.begin(), sut.end(), "transmission_controller." + text) - sut.begin();
  };
  EXPECT_LT(place("alpha=1"), place("alpha=2"));
  EXPECT_LT(place("alpha=2"), place("alpha=3"));
  EXPECT_LT(place("alpha=3"), static_cast<long>(sut.size()));
}

TEST(FittedFile, HasAKeyForEachFitOfAMission) {
  EXPECT_EQ(fitted_key("a", 1), "a");
  EXPECT_EQ(fitted_key("a", 3), "a/3");
  const Fitted sut = parse_fitted("a: {tocp: [alpha=2]}\na/2: {tocp: [alpha=3]}\n", "f.yaml");
  EXPECT_EQ(settings_for(sut, fitted_key("a", 2), "tocp"), std::vector<std::string>{"alpha=3"});
  EXPECT_EQ(parse_fitted(fitted_text(sut, "again"), "f.yaml"), sut);
}

TEST(FittedFile, IsTakenInTurnByTheRuns) {
  EXPECT_EQ(fit_of(1, 5), 1);
  EXPECT_EQ(fit_of(5, 5), 5);
  EXPECT_EQ(fit_of(6, 5), 1);
  EXPECT_EQ(fit_of(1001, 5), 1);
  EXPECT_EQ(fit_of(7, 1), 1);
}

const char* const two_fits = "fits: 2\nfitted: f.yaml\n";

TEST(FittedFile, GivesEachRunTheParametersOfItsFit) {
  const ToyExperiment toy(two_fits + std::string(toy_text));
  toy.write("f.yaml", "a: {tocp_dsp: [alpha=2]}\na/2: {tocp_dsp: [alpha=3]}\n");
  const auto plan = make_plan(toy.load());
  EXPECT_EQ(plan[3].id(), "main.a.near.camera.tocp_dsp.1");
  EXPECT_EQ(plan[3].fitted, std::vector<std::string>{"alpha=2"});
  EXPECT_EQ(plan[4].fitted, std::vector<std::string>{"alpha=3"});
  EXPECT_EQ(plan[5].fitted, std::vector<std::string>{"alpha=2"});
}

TEST(FittedFile, SaysWhenItHasFewerFitsThanTheExperiment) {
  const ToyExperiment toy(two_fits + std::string(toy_text));
  toy.write("f.yaml", "a: {tocp_dsp: [alpha=2]}\n");
  EXPECT_THAT(error_of([&] { (void)toy.load(); }),
              ::testing::AllOf(::testing::HasSubstr("experiment.fits: 2, but "),
                               ::testing::HasSubstr("has fits of mission a up to 1")));
}

}  // namespace
}  // namespace tocsin::experiment
