// SPDX-License-Identifier: Apache-2.0
#include "plan/experiment_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// What the toy file with one part replaced is refused for; "none" when it is taken.
std::string error_in(const std::string& old, const std::string& fresh) {
  return error_of([&] { (void)ToyExperiment(with(toy_text, old, fresh)).load(); });
}

TEST(ExperimentFile, ReadsEveryPart) {
  const ToyExperiment toy;
  const Experiment sut = toy.load();
  EXPECT_EQ(sut.timing.duration_s, 100);
  EXPECT_EQ(sut.missions[0].file, toy.path("a.yaml"));
  EXPECT_THAT(sut.missions[0].set, ElementsAre("navigator.speed_mps=0.1"));
  EXPECT_TRUE(sut.payloads[0].camera);
  EXPECT_EQ(sut.policies[1].policy, "tocp_dsp") << "as it is named";
  EXPECT_EQ(sut.sets[0].kind, SetKind::thesis);
  EXPECT_EQ(sut.sets[0].seeds, 3);
  EXPECT_THAT(sut.sets[0].missions, ElementsAre("a", "b")) << "all where none is named";
  EXPECT_THAT(sut.sets[0].payloads, ElementsAre("camera"));
}

TEST(ExperimentFile, TakesWhatMayBeOtherwise) {
  const std::pair<const char*, const char*> rows[] = {{"kind: thesis", "kind: comparison"},
                                                      {"kind: thesis", "kind: sensitivity"},
                                                      {"kind: thesis", "kind: real"},
                                                      {"kind: thesis", "kind: fit"},
                                                      {"warm_up_s: 0", "warm_up_s: 99.9"},
                                                      {"name: plain", "name: plain_2"},
                                                      {"duration_s: 100", "duration_s: 10"},
                                                      {"duration_s: 100", "duration_s: 86400"},
                                                      {"observation_s: 10", "observation_s: 1"},
                                                      {"observation_s: 10", "observation_s: 600"},
                                                      {"seeds: 3", "seeds: 100000"}};
  for (const auto& [old, fresh] : rows) EXPECT_EQ(error_in(old, fresh), "none") << fresh;
}

/// Part of the toy file, what stands in its place, and what is said of it.
const struct {
  const char* old;
  const char* fresh;
  const char* error;
  const char* place;
} wrong[] = {
    {"warm_up_s", "warmup_s", "warmup_s", ":2)"},
    {"file: b.yaml", "path: b.yaml", "path", ":6)"},
    {"seeds: 3", "seeds: 0", "sets[0].seeds: 0 is outside [", ":16)"},
    {"seeds: 3", "seeds: 100001", "is outside [", ":16)"},
    {"seeds: 3", "seeds: 2.5", "2.5 is not a whole number", ""},
    {"duration_s: 100", "duration_s: 9.9", "is outside [", ":1)"},
    {"duration_s: 100", "duration_s: 86401", "is outside [", ":1)"},
    {"duration_s: 100", "duration_s: long", "duration_s: 'long' is not a number", ":1)"},
    {"duration_s: 100", "duration_s: .nan", "duration_s", ""},
    {"warm_up_s: 0", "warm_up_s: -0.1", "is outside [", ""},
    {"warm_up_s: 0", "warm_up_s: 100", "less than duration_s", ""},
    {"observation_s: 10", "observation_s: 0.9", "is outside [", ""},
    {"observation_s: 10", "observation_s: 601", "is outside [", ""},
    {"warm_up_s: 0", "poor_below_snr_db: 60.1", "experiment.poor_below_snr_db: ", ":2)"},
    {"warm_up_s: 0", "vehicles: 2", "vehicles: 2 is not possible, a bringup file has one", ""},
    {"warm_up_s: 0", "cost: {high_late: -1}", "experiment.cost.high_late: -1 is outside", ":2)"},
    {"warm_up_s: 0", "cost: {hi: 1}", "experiment.cost.hi: unknown key", ""},
    {"camera: true", "camera: maybe", "payloads[0].camera: 'maybe'", ":10)"},
    {"kind: thesis", "kind: thorough", "sets[0].kind: 'thorough' is not one of", ""},
    {"set: [navigator.speed_mps=0.1]", "set: navigator.speed_mps=0.1",
     "missions[0].set: is not a list of texts", ":5)"},
    {"payloads: [camera]", "payloads: [video]", "'video' is not one of [camera, plain]", ":16)"},
    {"payloads: [camera]", "missions: [a, c]", "sets.main.missions: 'c' is not one of [a, b]",
     ":16)"},
    {"payloads: [camera]", "channels: [far]", "sets.main.channels: 'far' is not one of [near]", ""},
    {"payloads: [camera]", "policies: [luck]", "'luck' is not one of [none, tocp_dsp]", ""},
    {"{name: near,", "{name: near, seeds_of: far,", "seeds_of: 'far' is not a channel", ""},
    {"name: b", "name: a", "a twice", ":6)"},
    {"name: tocp_dsp", "name: none", "policies[1].name: none twice", ""},
    {"{name: plain}", "{camera: false}", "payloads[1].name: '' is not a name", ""},
    {"name: plain", "name: Plain", "is not a name", ""},
    {"name: plain", "name: pl/ain", "is not a name", ""},
    {"name: plain", "name: 'pl ain'", "is not a name", ""},
    {"near_${mission}.yaml", "far.yaml", "channels[0].file: no file '", ""},
    {"file: b.yaml", "file: c.yaml", "missions[1].file: no file '", ":6)"},
    {"payloads:\n  - {name: camera, camera: true}\n  - {name: plain}\n", "",
     "experiment.payloads: is not a list", ""},
    {"payloads:\n  - {name: camera, camera: true}\n  - {name: plain}\n",
     "payloads: {name: camera}\n", "payloads: is not a list with at least one entry", ""},
    {"{name: plain}", "plain", "payloads[1]: must be a map", ""},
    {"sets:", "sets: [", "toy.yaml", ""}};

TEST(ExperimentFile, NamesWhatIsWrongAndItsLine) {
  for (const auto& row : wrong) {
    const std::string error = error_in(row.old, row.fresh);
    EXPECT_THAT(error, HasSubstr(row.error)) << row.fresh;
    EXPECT_THAT(error, HasSubstr(row.place)) << row.fresh;
  }
}

TEST(ExperimentFile, RefusesAFileThatIsNone) {
  EXPECT_THAT(error_of([] { (void)ToyExperiment("- 1\n").load(); }), HasSubstr("is not a map"));
  EXPECT_NE(error_of([] { (void)ToyExperiment("").load(); }), "none");
  EXPECT_THAT(error_of([] { (void)load_experiment("/nonexistent.yaml"); }),
              HasSubstr("/nonexistent.yaml"));
  EXPECT_THAT(error_of([] { (void)parse_experiment("a: [", "old/settings.yaml"); }),
              HasSubstr("old/settings.yaml"));
}

TEST(ExperimentFile, HasWeightsOfItsOwn) {
  EXPECT_EQ(ToyExperiment().load().timing.cost.critical_late, 10);
  const ToyExperiment sut(std::string(toy_text) + "cost: {critical_late: 3}\n");
  EXPECT_EQ(sut.load().timing.cost.critical_late, 3);
  EXPECT_EQ(sut.load().timing.cost.high_late, 4);
}

TEST(ExperimentFile, IsParsedWithoutItsFiles) {
  EXPECT_EQ(parse_experiment(toy_text, "/nowhere/toy.yaml").missions.size(), 2U);
}

TEST(ExperimentFile, ReadsPathsFromItsFolder) {
  const ToyExperiment toy(with(toy_text, "file: b.yaml", "file: ./sub/../b.yaml"));
  toy.write("sub/unused.yaml", "x: 1\n");
  EXPECT_EQ(toy.load().missions[1].file, toy.path("b.yaml"));
}

TEST(ExperimentFile, LetsNamesDiffer) {
  const ToyExperiment untitled(with(toy_text, "title: The main set, ", ""));
  EXPECT_EQ(untitled.load().sets[0].title, "main");
  const ToyExperiment toy(with(toy_text, "{name: none}", "{name: silent_never, policy: none}"));
  EXPECT_EQ(toy.load().policies[0].name, "silent_never");
  EXPECT_EQ(toy.load().policies[0].policy, "none");
}

TEST(ExperimentFile, ShippedOnesLoad) {
  const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/experiments/";
  for (const auto& [file, runs] :
       {std::pair{"thesis.yaml", 800U}, {"replay.yaml", 15U}, {"link.yaml", 560U}}) {
    EXPECT_EQ(make_plan(load_experiment(config + file)).size(), runs) << file;
  }
  int fitted = 0;
  for (const RunSet& set : load_experiment(config + "study.yaml").sets) {
    const bool fit = set.kind == SetKind::fit;
    EXPECT_EQ(set.first_seed > 1000, fit) << set.name << ": fits have seeds of their own";
    if (fit) fitted += set.seeds;
  }
  EXPECT_EQ(fitted, 20);
}

}  // namespace
}  // namespace tocsin::experiment
