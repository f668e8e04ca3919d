// SPDX-License-Identifier: Apache-2.0
// Files that the command line puts in place of the bringup file's.
#include "deployment/deployment.hpp"
#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::HasSubstr;

TEST_F(DeploymentTest, TakesTheFilesOfTheCommandLine) {
  overrides_.channel = write("other_channel.yaml", "{}");
  overrides_.qos = write("other_qos.yaml", "{}");
  overrides_.traffic = write("other_traffic.yaml", "{}");
  EXPECT_EQ(load(whole).radio->channel, path("other_channel.yaml"));
  EXPECT_EQ(load(whole).qos, path("other_qos.yaml"));
  EXPECT_EQ(load(whole).traffic, path("other_traffic.yaml"));
}

TEST_F(DeploymentTest, RejectsAChannelThatIsNotThereOrHasNoRadio) {
  overrides_.channel = "/nowhere/channel.yaml";
  EXPECT_THAT(error_of(whole), HasSubstr("channel: no file /nowhere/channel.yaml"));
  overrides_.channel.clear();
  overrides_.traffic = "/nowhere/traffic.yaml";
  EXPECT_THAT(error_of(whole), HasSubstr("--traffic /nowhere/traffic.yaml: is no file"));
  overrides_.qos = "/nowhere/qos.yaml";
  EXPECT_THAT(error_of(whole), HasSubstr("--qos /nowhere/qos.yaml: is no file"));
  overrides_.qos = overrides_.traffic = "";
  overrides_.channel = "/nowhere/channel.yaml";
  const std::string radio = "radio:\n  channel: ../channel.yaml\n  walls: ../walls.yaml\n";
  EXPECT_THAT(error_of(with(whole, radio, "")), HasSubstr("no channel to replace"));
}

}  // namespace
}  // namespace tocsin::deployment
