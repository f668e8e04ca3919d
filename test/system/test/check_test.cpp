// SPDX-License-Identifier: Apache-2.0
// `tocsin check` as installed: on the shipped files, and on the example of deployment's README.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

Ended check(const std::string& arguments) {
  return run_to_end(Stack::program("tocsin-check"), arguments);
}

TEST(Check, HasNoWarningForTheShippedFiles) {
  for (const char* file :
       {"mission.yaml", "obstacles.yaml", "foresight.yaml", "survey.yaml", "two_paths.yaml",
        "two_sites.yaml", "teleop.yaml", "dock.yaml", "vehicle.yaml", "station.yaml",
        // What the packages put into /etc/tocsin.
        TOCSIN_REPOSITORY "/bringup/packaging/etc/vehicle.yaml",
        TOCSIN_REPOSITORY "/bringup/packaging/etc/station.yaml",
        TOCSIN_REPOSITORY "/bringup/packaging/etc/gateway.yaml"}) {
    const Ended ended = check(std::string(file) + " --strict");
    EXPECT_EQ(ended.code, 0) << file;
    EXPECT_THAT(ended.output, EndsWith("components; 0 errors, 0 warnings\n"));
    EXPECT_EQ(ended.output.find('\n'), ended.output.size() - 1) << ended.output;
  }
}

TEST(Check, WantsOneRouterOnEachHost) {
  const std::string one_side = "mission.yaml --without gcs/link/link_router";
  const Ended deaf = check(one_side);
  EXPECT_EQ(deaf.code, 2);
  EXPECT_THAT(deaf.output, HasSubstr("error: host gcs has no link_router, its peer uxv has"));
  const Ended neither = check(one_side + " --without uxv/link/link_router");
  EXPECT_EQ(neither.code, 2);
  EXPECT_THAT(neither.output, HasSubstr("error: host gcs: no link_router carries the link topics"));
  EXPECT_THAT(neither.output, HasSubstr("2 errors, 0 warnings"));
}

TEST(Check, RefusesATrafficFileByWhichTheLinkWouldDriveTheVehicle) {
  const TemporaryFolder folder;
  const std::string named = folder.write(
      "named.yaml", "extends: traffic.yaml\ngcs:\n  high: {topics: [goal, cmd_vel/teleop]}\n");
  const Ended refused = check("mission.yaml --traffic " + named);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.output, HasSubstr("error: gcs.high.topics: cmd_vel/teleop moves or stops"));
  EXPECT_THAT(refused.output, HasSubstr("named.yaml:3"));
  const std::string pattern =
      folder.write("pattern.yaml", "extends: traffic.yaml\nuxv:\n  low: {topics: ['*']}\n");
  const Ended taken = check("mission.yaml --traffic " + pattern);
  EXPECT_EQ(taken.code, 2);
  EXPECT_THAT(taken.output, HasSubstr("error: uxv.low.topics: * takes cmd_vel, which moves"));
}

TEST(Check, LetsVelocitiesCrossToARobotThatIsNotOurs) {
  const Ended ended = check("gateway.yaml");
  EXPECT_EQ(ended.code, 0) << ended.output;
}

TEST(Check, LooksAtAFileWithoutContainers) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("one.yaml",
                   "hosts: {uxv: {role: uxv, address: 127.0.0.1, programs: [{name: a, command: "
                   "[\"true\"]}]}}");
  const Ended ended = check(file);
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.output, HasSubstr("0 components; 0 errors, 0 warnings"));
}

TEST(Check, TheExampleOfAFileThatExtendsTheMissionIsRight) {
  std::vector<std::string> blocks;
  for (const auto& one :
       readme_files(TOCSIN_REPOSITORY "/components/framework/deployment/README.md")) {
    if (one.language == "yaml") blocks.push_back(one.text);
  }
  ASSERT_EQ(blocks.size(), 2U);
  const TemporaryFolder folder;
  ASSERT_EQ(blocks[0].rfind("# robot.yaml:", 0), 0U);
  ASSERT_EQ(blocks[1].rfind("# traffic.yaml", 0), 0U);
  const std::string robot = folder.write("robot.yaml", blocks[0]);
  (void)folder.write("traffic.yaml", blocks[1]);
  const Ended right = check(robot);
  EXPECT_EQ(right.code, 0) << right.output;
  EXPECT_THAT(right.output, HasSubstr("21 components; 0 errors"));  // the mission has 22
  const Ended wrong = check(robot + " --set camera.rate_hz=1");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.output, HasSubstr("camera: no such component in " + robot));
}

}  // namespace
}  // namespace tocsin
