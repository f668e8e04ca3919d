// SPDX-License-Identifier: Apache-2.0
#include "joint_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <random>

#include "decision/quality_index.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/temporary_folder.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

class JointReportTest : public ::testing::Test {
 protected:
  /// A recording of round-trip time and signal, so much slower and weaker; loss and retries are 0.
  std::string recording(const std::string& name, double slower, double weaker) const {
    std::mt19937_64 random(7);  // NOLINT: a fixed seed is the point
    std::normal_distribution<double> normal(0, 1);
    std::string text = "receive_s,per_percent,rtt_mean_ms,signal_dbm,retry_percent\n";
    for (int i = 0; i < 400; ++i) {
      const double rtt = 5 * std::exp(0.2 * normal(random)) + slower;
      text += std::to_string(i) + ",0," + std::to_string(rtt) + "," +
              std::to_string(-60 - weaker + 2 * normal(random)) + ",\n";
    }
    return folder_.write(name, text);
  }
  TemporaryFolder folder_;
};

TEST_F(JointReportTest, ReadsTheReadingsOfARecording) {
  const std::string path = folder_.write(
      "a.csv", "receive_s,per_percent,rtt_mean_ms,signal_dbm\n1,5,12.5,-70\n2,100,,\n");
  const auto sut = read_measurements(path);
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].per_percent, 5);
  EXPECT_EQ(sut[0].rtt_ms, 12.5);
  EXPECT_TRUE(std::isnan(*sut[0].retry_percent));  // a column that is not there
  EXPECT_TRUE(std::isnan(*sut[1].rtt_ms));
}

TEST_F(JointReportTest, WritesParametersThatAControllerTakes) {
  const auto fit = fit_joint_files(recording("good.csv", 0, 0),
                                   {recording("weak.csv", 0, 15), recording("slow.csv", 40, 0)});
  const std::string text = joint_text(fit, "test");
  EXPECT_THAT(text, HasSubstr("# test\n"));
  YAML::Node node = YAML::Load(text);
  EXPECT_NEAR(node["good_mean"].as<double>(), fit.good.mean, 0.01);
  EXPECT_LT(node["bad_mean"].as<double>(), 40);
  for (const char* law : {"good_mean", "good_sd", "bad_mean", "bad_sd"}) node.remove(law);
  const auto params = load_parameters<decision::QualityIndexParams>(node, "index", "text");
  const decision::QualityIndex sut(params);
  EXPECT_GT(sut.evaluate({0, -60, {}, {}, {}, 5}), 70);
  EXPECT_LT(sut.evaluate({0, -75, {}, {}, {}, 5}), 30);
  EXPECT_LT(sut.evaluate({0, -60, {}, {}, {}, 45}), 30);
}

TEST_F(JointReportTest, NamesTheFilesOfWhichNoneFalls) {
  const std::string good = recording("good.csv", 0, 0);
  try {
    (void)fit_joint_files(good, {good});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("good.csv (good), "));
    EXPECT_THAT(error.what(), HasSubstr("no reading falls"));
  }
}

}  // namespace
}  // namespace tocsin::tools
