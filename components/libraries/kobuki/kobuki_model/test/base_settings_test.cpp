// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/base_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::HasSubstr;

class BaseSettingsTest : public ::testing::Test {
 protected:
  BaseSettings load(const std::string& text) {
    return load_base_settings(folder_.write("base.yaml", text));
  }
  std::string error_of(const std::string& text) {
    try {
      (void)load(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(BaseSettingsTest, AreReadFromYaml) {
  const BaseSettings sut = load("model: {slip_sigma: 0.2}\nline: {usb_latency_ms: 16}\n");
  EXPECT_EQ(sut.model.slip_sigma, 0.2);
  EXPECT_EQ(sut.line.usb_latency_ms, 16);
  EXPECT_EQ(load("line: {}\n").model.slip_sigma, ModelParams{}.slip_sigma);
}

TEST_F(BaseSettingsTest, AreRefusedWithKeyAndRange) {
  EXPECT_THAT(error_of("line: {usb_latency_ms: 17}"), HasSubstr("17 is outside [1, 16]"));
  EXPECT_THAT(error_of("model: {}\nmodle: {}"),
              HasSubstr("modle: unknown key; allowed: [model, line]; did you mean 'model'?"));
  EXPECT_THAT(error_of("model: {}\nmodle: {}"), HasSubstr("base.yaml:2"));
  EXPECT_THAT(error_of("model: {speed: 1}"), HasSubstr("unknown key"));
  EXPECT_THAT(error_of("[model]"), HasSubstr("must be a map"));
}

TEST(ParsePose, TakesThreeNumbers) {
  const geometry::Pose pose = parse_pose("--start", "1.5,-2,0.1");
  EXPECT_EQ(pose.x_m, 1.5);
  EXPECT_EQ(pose.y_m, -2);
  EXPECT_EQ(pose.heading_rad, 0.1);
  for (const char* bad : {"", "1,2", "1,2,3,4", "1,2,3x", "1,2,nan", "a,b,c"}) {
    EXPECT_THROW((void)parse_pose("--start", bad), ConfigError) << bad;
  }
}

}  // namespace
}  // namespace tocsin::kobuki
