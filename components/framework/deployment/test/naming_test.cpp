// SPDX-License-Identifier: Apache-2.0
// Processes, components and hosts as the command line names them.
#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::HasSubstr;

using NamingTest = DeploymentTest;

TEST_F(NamingTest, LeavesOutAProcess) {
  overrides_.without = {"uxv/base", "gcs/mission"};
  const Deployment sut = load(whole);
  EXPECT_TRUE(sut.hosts[0].programs.empty());
  EXPECT_TRUE(sut.hosts[1].containers.empty());
  EXPECT_THAT(sut.stop_when_exits, ::testing::IsEmpty());
  overrides_.without = {"uxv/bass"};
  EXPECT_THAT(error_of(whole),
              HasSubstr("--without uxv/bass: no such process; allowed: [uxv/base"));
}

TEST_F(NamingTest, LeavesOutAComponentOfAProcess) {
  const Deployment all = load(whole);
  const Container& container = all.hosts[0].containers[0];
  const std::string name = container.components[0].name;
  overrides_.without = {"uxv/" + container.name + "/" + name};
  const Deployment sut = load(whole);
  const auto& left = sut.hosts[0].containers[0].components;
  EXPECT_EQ(left.size() + 1, container.components.size());
  for (const ComponentInstance& one : left) EXPECT_NE(one.name, name);
  overrides_.without = {"uxv/" + container.name + "/nobody"};
  EXPECT_THAT(error_of(whole), HasSubstr("no such process"));
}

TEST_F(NamingTest, AsksWhichProcessShallBeLeftOut) {
  overrides_.without = {"base"};
  const std::string two = with(whole, "name: mission,", "name: base,");
  EXPECT_THAT(error_of(with(two, "stop_when_exits: gcs/mission\n", "")),
              HasSubstr("--without base: which process? One of [uxv/base, gcs/base]"));
}

TEST_F(NamingTest, FindsTheHostThatAnOptionNames) {
  const Deployment sut = load(with(with(whole, "  gcs:", "  station:"), "gcs/mission", "uxv/base"));
  EXPECT_EQ(host_named(sut, "uxv").name, "uxv");
  EXPECT_EQ(host_named(sut, "/station").name, "station");
  EXPECT_EQ(host_named(sut, "gcs").name, "station") << "by its role";
  try {
    (void)host_named(sut, "sea");
    ADD_FAILURE();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--host sea: no such host in "));
    EXPECT_THAT(error.what(), HasSubstr("allowed: [uxv, station]"));
  }
}

}  // namespace
}  // namespace tocsin::deployment
