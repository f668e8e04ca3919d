// SPDX-License-Identifier: Apache-2.0
#include "tune/tune_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::HasSubstr;

const char* const toy =
    "duration_s: 60\n"
    "missions:\n"
    "  - {name: b, file: missions/b.yaml}\n"
    "channels:\n"
    "  - {name: near, file: near.yaml}\n"
    "payloads:\n"
    "  - {name: camera, camera: true}\n"
    "seeds: 4\n"
    "sweep:\n"
    "  qos.stream.lifespan_s: [0.25, 1]\n"
    "  class.uxv.camera: [normal, high]\n"
    "  link_router.scale_min: [0.25]\n";

/// A tune file beside a QoS and a traffic file.
class TunePlanTest : public ::testing::Test {
 protected:
  TunePlanTest() {
    folder_.write("qos.yaml", "stream: {depth: 1, lifespan_s: 2}\nstate: {depth: 1}\n");
    folder_.write("traffic.yaml",
                  "uxv:\n  high: {topics: [location]}\n"
                  "  low: {topics: [camera], adaptive: [camera], compress: ['*']}\ngcs: {}\n");
  }
  TunePlan plan(const std::string& text = toy) {
    return read_tune_plan(folder_.write("tune.yaml", text), folder_.path());
  }
  std::string error(const std::string& old, const std::string& fresh) {
    std::string text = toy;
    text.replace(text.find(old), old.size(), fresh);
    try {
      (void)plan(text);
    } catch (const ConfigError& refused) {
      return refused.what();
    }
    return "none";
  }
  TemporaryFolder folder_;
};

TEST_F(TunePlanTest, TriesWhatThereIsAndEveryCombination) {
  const auto sut = candidates_of(plan());
  ASSERT_EQ(sut.size(), 5U);
  EXPECT_EQ(sut[0].name, "shipped");
  EXPECT_EQ(settings_text(sut[0]), "as shipped");
  EXPECT_EQ(sut[1].name, "c1");
  EXPECT_EQ(settings_text(sut[1]),
            "qos.stream.lifespan_s=0.25 class.uxv.camera=normal link_router.scale_min=0.25");
  EXPECT_EQ(settings_text(sut[4]),
            "qos.stream.lifespan_s=1 class.uxv.camera=high link_router.scale_min=0.25");
}

TEST_F(TunePlanTest, TheQosFileOfACandidateIsTheShippedOneButForWhatIsSwept) {
  const TunePlan sut = plan();
  const auto all = candidates_of(sut);
  EXPECT_EQ(qos_text(sut, all[0]), "");
  const QosProfiles profiles(folder_.write("c1.yaml", qos_text(sut, all[1])));
  EXPECT_EQ(profiles.all().at("stream").lifespan_s, 0.25);
  EXPECT_EQ(profiles.all().at("stream").depth, 1);
  EXPECT_EQ(profiles.all().count("state"), 1U);
}

TEST_F(TunePlanTest, TheTrafficFileMovesATopicWithItsAdaptationAndCompression) {
  const TunePlan sut = plan();
  const auto all = candidates_of(sut);
  EXPECT_EQ(traffic_text(sut, all[0]), "");
  const TrafficRules rules(folder_.write("c2.yaml", traffic_text(sut, all[2])), Role::uxv);
  EXPECT_EQ(rules.of("camera").traffic_class, TrafficClass::high);
  EXPECT_TRUE(rules.of("camera").adaptive);
  EXPECT_TRUE(rules.of("camera").compressed);
  EXPECT_EQ(rules.of("location").traffic_class, TrafficClass::high);
}

TEST_F(TunePlanTest, TheExperimentHasAPolicyForEachCandidateAndOneSet) {
  const TunePlan sut = plan();
  const YAML::Node file = YAML::Load(experiment_text(sut, candidates_of(sut)));
  ASSERT_EQ(file["policies"].size(), 5U);
  EXPECT_EQ(file["policies"][0]["name"].Scalar(), "shipped");
  EXPECT_FALSE(file["policies"][0]["qos"]);
  EXPECT_EQ(file["policies"][2]["qos"].Scalar(), "c2.qos.yaml");
  EXPECT_EQ(file["policies"][2]["traffic"].Scalar(), "c2.traffic.yaml");
  EXPECT_EQ(file["policies"][2]["set"][0].Scalar(), "link_router.scale_min=0.25");
  EXPECT_EQ(file["policies"][2]["policy"].Scalar(), "none");
  EXPECT_EQ(file["sets"][0]["seeds"].as<int>(), 4);
  EXPECT_EQ(file["missions"][0]["file"].Scalar(), folder_.path("missions/b.yaml"));
  EXPECT_FALSE(file["sweep"]);
  EXPECT_FALSE(file["seeds"]);
}

TEST(ShippedTuneFile, IsSoundAndEndsWithinAnHour) {
  const TunePlan sut = read_tune_plan(TOCSIN_REPOSITORY "/config/experiments/tune.yaml",
                                      TOCSIN_REPOSITORY "/config");
  const auto all = candidates_of(sut);
  EXPECT_EQ(all.size(), 28U);
  for (const Candidate& candidate : all) {
    if (candidate.settings.empty()) continue;
    EXPECT_THAT(qos_text(sut, candidate), HasSubstr("stream:\n  lifespan_s: "));
    EXPECT_THAT(traffic_text(sut, candidate), HasSubstr("topics: [location]"));
  }
}

TEST_F(TunePlanTest, RefusesWhatItCannotSet) {
  EXPECT_THAT(error("qos.stream.lifespan_s", "lifespan_s"),
              HasSubstr("sweep: 'lifespan_s' is none of qos.PROFILE.POLICY, class.ROLE.TOPIC"));
  EXPECT_THAT(error("qos.stream.lifespan_s", "qos.stream.lifspan_s"), HasSubstr("lifspan_s"));
  EXPECT_THAT(error("qos.stream.lifespan_s", "qos.steam.lifespan_s"), HasSubstr("steam"));
  EXPECT_THAT(error("[0.25, 1]", "[-1]"), HasSubstr("lifespan_s"));
  EXPECT_THAT(error("[0.25, 1]", "0.25"), HasSubstr("is no list of values"));
  EXPECT_THAT(error("class.uxv.camera", "class.base.camera"), HasSubstr("none of the roles"));
  EXPECT_THAT(error("class.uxv.camera", "class.uxv.camra"), HasSubstr("camra"));
  EXPECT_THAT(error("[normal, high]", "[urgent]"), HasSubstr("'urgent' is none of critical"));
  EXPECT_THAT(error("seeds: 4", "seeds: 1"), HasSubstr("tune.seeds: 1 is outside [2, 1000]"));
  EXPECT_THAT(error("duration_s: 60", "sets: []"), HasSubstr("sets: are those of the sweep"));
}

TEST_F(TunePlanTest, RefusesAFileWithoutASweep) {
  EXPECT_THAT(error("sweep:\n", "swept:\n"), HasSubstr("sweep: is no map of settings"));
}

TEST_F(TunePlanTest, RefusesMoreCombinationsThanAnybodyWaitsFor) {
  std::string values = "[1";
  for (int i = 2; i <= 15; ++i) values += ", " + std::to_string(i);
  EXPECT_THAT(
      error("link_router.scale_min: [0.25]", "a.x: " + values + "]\n  a.y: " + values + "]"),
      HasSubstr("more than 200 combinations"));
}

}  // namespace
}  // namespace tocsin::qos_tool
