// SPDX-License-Identifier: Apache-2.0
// Each way in which an experiment file can be wrong, with the line that is to be told, and both
// sides of each limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/experiment_file.hpp"
#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What the toy file with one part replaced is refused for; "none" when it is taken.
std::string error_in(const std::string& old, const std::string& fresh) {
  return error_of([&] { (void)ToyExperiment(with(toy_text, old, fresh)).load(); });
}

/// The same with a line put before the others.
std::string error_with(const std::string& line) {
  return error_of([&] { (void)ToyExperiment(line + "\n" + toy_text).load(); });
}

/// A limit of a number: the last value that is taken and the first that is not.
struct Limit {
  const char* key;
  const char* taken;
  const char* refused;
};

class TimingLimit : public ::testing::TestWithParam<Limit> {};

TEST_P(TimingLimit, HasTwoSides) {
  const Limit& limit = GetParam();
  const std::string key = limit.key;
  EXPECT_EQ(error_with(key + ": " + limit.taken), "none");
  EXPECT_THAT(error_with(key + ": " + limit.refused),
              AllOf(HasSubstr("experiment." + key + ": "), HasSubstr("is outside ["),
                    HasSubstr("toy.yaml:1)")));
}

INSTANTIATE_TEST_SUITE_P(ExperimentFile, TimingLimit,
                         ::testing::Values(Limit{"poor_below_snr_db", "-20", "-20.1"},
                                           Limit{"poor_below_snr_db", "60", "60.1"},
                                           Limit{"vehicles", "1", "0"}));

/// The same of keys that the toy file has already.
class ToyLimit : public ::testing::TestWithParam<Limit> {};

TEST_P(ToyLimit, HasTwoSides) {
  const Limit& limit = GetParam();
  const std::string key = std::string(limit.key).substr(0, std::string(limit.key).find(':'));
  EXPECT_EQ(error_in(limit.key, key + ": " + limit.taken), "none");
  EXPECT_THAT(error_in(limit.key, key + ": " + limit.refused),
              AllOf(HasSubstr(key + ": "), HasSubstr("is outside [")));
}

INSTANTIATE_TEST_SUITE_P(ExperimentFile, ToyLimit,
                         ::testing::Values(Limit{"duration_s: 100", "10", "9.9"},
                                           Limit{"duration_s: 100", "86400", "86401"},
                                           Limit{"warm_up_s: 0", "0", "-0.1"},
                                           Limit{"observation_s: 10", "1", "0.9"},
                                           Limit{"observation_s: 10", "600", "601"},
                                           Limit{"seeds: 3", "1", "0"},
                                           Limit{"seeds: 3", "100000", "100001"}));

TEST(ExperimentFileError, NamesANumberThatIsNone) {
  EXPECT_THAT(error_in("duration_s: 100", "duration_s: long"),
              AllOf(HasSubstr("duration_s: 'long' is not a number"), HasSubstr(":1)")));
  EXPECT_THAT(error_in("duration_s: 100", "duration_s: .nan"), HasSubstr("duration_s"));
}

TEST(ExperimentFileError, NamesAPartOfASeed) {
  EXPECT_THAT(error_in("seeds: 3", "seeds: 2.5"), HasSubstr("2.5 is not a whole number"));
}

TEST(ExperimentFileError, NamesACameraThatIsNeitherThereNorNot) {
  EXPECT_THAT(error_in("camera: true", "camera: maybe"),
              AllOf(HasSubstr("payloads[0].camera: 'maybe'"), HasSubstr(":10)")));
}

TEST(ExperimentFileError, NamesAKindThatThereIsNot) {
  EXPECT_THAT(error_in("kind: thesis", "kind: thorough"),
              AllOf(HasSubstr("sets[0].kind: 'thorough' is not one of"),
                    HasSubstr("comparison, sensitivity, real, fit")));
}

TEST(ExperimentFileError, TakesEveryKindThatThereIs) {
  for (const char* kind : {"thesis", "comparison", "sensitivity", "real", "fit"}) {
    EXPECT_EQ(error_in("kind: thesis", std::string("kind: ") + kind), "none") << kind;
  }
}

TEST(ExperimentFileError, NamesASettingThatIsNoList) {
  EXPECT_THAT(error_in("set: [navigator.speed_mps=0.1]", "set: navigator.speed_mps=0.1"),
              AllOf(HasSubstr("missions[0].set: is not a list of texts"), HasSubstr(":5)")));
}

TEST(ExperimentFileError, NamesTheSetThatNamesAMissionThatIsNot) {
  EXPECT_THAT(error_in("payloads: [camera]", "missions: [a, c]"),
              AllOf(HasSubstr("sets.main.missions: 'c' is not one of [a, b]"), HasSubstr(":16)")));
}

TEST(ExperimentFileError, NamesTheSetThatNamesAChannelThatIsNot) {
  EXPECT_THAT(error_in("payloads: [camera]", "channels: [far]"),
              HasSubstr("sets.main.channels: 'far' is not one of [near]"));
}

TEST(ExperimentFileError, NamesTheSetThatNamesAPolicyThatIsNot) {
  EXPECT_THAT(error_in("payloads: [camera]", "policies: [luck]"),
              HasSubstr("sets.main.policies: 'luck' is not one of [none, tocp_dsp]"));
}

TEST(ExperimentFileError, NamesAPolicyThatIsThereTwice) {
  EXPECT_THAT(error_in("name: tocp_dsp", "name: none"), HasSubstr("policies[1].name: none twice"));
}

TEST(ExperimentFileError, NamesAnEntryWithoutAName) {
  EXPECT_THAT(error_in("{name: plain}", "{camera: false}"),
              HasSubstr("payloads[1].name: '' is not a name"));
}

TEST(ExperimentFileError, RefusesNamesThatAreNoWordsOfAFileName) {
  for (const char* name : {"Plain", "pl.ain", "pl/ain", "pl-ain", "'pl ain'"}) {
    EXPECT_THAT(error_in("name: plain", std::string("name: ") + name), HasSubstr("is not a name"))
        << name;
  }
  EXPECT_EQ(error_in("name: plain", "name: plain_2"), "none");
}

TEST(ExperimentFileError, NamesAChannelFileThatIsNotThere) {
  EXPECT_THAT(error_in("near_${mission}.yaml", "far.yaml"),
              AllOf(HasSubstr("channels[0].file: no file '"), HasSubstr("far.yaml'")));
}

TEST(ExperimentFileError, NamesTheSecondMissionWhenItsFileIsMissing) {
  EXPECT_THAT(error_in("file: b.yaml", "file: c.yaml"),
              AllOf(HasSubstr("missions[1].file: no file '"), HasSubstr(":6)")));
}

TEST(ExperimentFileError, RefusesAFileThatIsAListOrEmpty) {
  EXPECT_THAT(error_of([] { (void)ToyExperiment("- 1\n").load(); }), HasSubstr("is not a map"));
  EXPECT_NE(error_of([] { (void)ToyExperiment("").load(); }), "none");
}

TEST(ExperimentFileError, RefusesAListThatIsAMap) {
  EXPECT_THAT(error_in("payloads:\n  - {name: camera, camera: true}\n  - {name: plain}\n",
                       "payloads: {name: camera}\n"),
              HasSubstr("experiment.payloads: is not a list with at least one entry"));
}

TEST(ExperimentFileError, RefusesAnEntryThatIsNoMap) {
  EXPECT_THAT(error_in("{name: plain}", "plain"), HasSubstr("payloads[1]: must be a map"));
}

TEST(ExperimentFileError, RefusesAWarmUpAsLongAsTheRun) {
  EXPECT_EQ(error_in("warm_up_s: 0", "warm_up_s: 99.9"), "none");
  EXPECT_THAT(error_in("warm_up_s: 0", "warm_up_s: 100"), HasSubstr("warm_up_s"));
}

TEST(ExperimentFileError, RefusesTwoVehiclesAndSaysWhy) {
  EXPECT_THAT(error_with("vehicles: 2"),
              HasSubstr("experiment.vehicles: 2 is not possible, a bringup file has one vehicle"));
}

TEST(ExperimentFileError, NamesTheFileOfTextThatIsNotYaml) {
  EXPECT_THAT(error_of([] { (void)parse_experiment("a: [", "old/settings.yaml"); }),
              HasSubstr("old/settings.yaml"));
}

TEST(ExperimentFileDefaults, AreThoseOfTheReadme) {
  const Timing sut;
  EXPECT_EQ(sut.bringup, "mission.yaml");
  EXPECT_THAT(sut.without, ::testing::ElementsAre("gcs/view"));
  EXPECT_EQ(sut.duration_s, 600);
  EXPECT_EQ(sut.warm_up_s, 10);
  EXPECT_EQ(sut.observation_s, 6);
  EXPECT_EQ(sut.poor_below_snr_db, 10);
}

TEST(ExperimentFileDefaults, CallASetWithoutATitleByItsName) {
  const ToyExperiment toy(with(toy_text, "title: The main set, ", ""));
  EXPECT_EQ(toy.load().sets[0].title, "main");
}

TEST(ExperimentFileDefaults, ReadPathsFromTheFolderOfTheFile) {
  const ToyExperiment toy(with(toy_text, "file: b.yaml", "file: ./sub/../b.yaml"));
  toy.write("sub/unused.yaml", "x: 1\n");
  EXPECT_EQ(toy.load().missions[1].file, toy.path("b.yaml"));
}

TEST(ExperimentFileDefaults, LetAPolicyHaveAnotherNameThanItsRule) {
  const ToyExperiment toy(with(toy_text, "{name: none}", "{name: silent_never, policy: none}"));
  EXPECT_EQ(toy.load().policies[0].name, "silent_never");
  EXPECT_EQ(toy.load().policies[0].policy, "none");
}

}  // namespace
}  // namespace tocsin::experiment
