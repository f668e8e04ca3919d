// SPDX-License-Identifier: Apache-2.0
#include "interfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::doctor {
namespace {

using ::testing::HasSubstr;

TEST(Interfaces, AnAddressThatIsNotHereIsNoFault) {
  EXPECT_EQ(judge_address("10.0.0.1", {}).fitness, Fitness::unknown);
}

TEST(Interfaces, AnInterfaceThatIsDownIsNamedWithTheCommand) {
  const Advice advice = judge_address("10.0.0.1", {{"wlan0", "10.0.0.1", false, false}});
  EXPECT_EQ(advice.fitness, Fitness::bad);
  EXPECT_EQ(advice.remedy, "ip link set wlan0 up");
}

TEST(Interfaces, AnInterfaceWithoutCarrierIsBad) {
  const Advice advice = judge_address("10.0.0.1", {{"wlan0", "10.0.0.1", true, false}});
  EXPECT_EQ(advice.fitness, Fitness::bad);
  EXPECT_THAT(advice.text, HasSubstr("no carrier"));
}

TEST(Interfaces, LoopbackMustBeThere) {
  EXPECT_EQ(judge_loopback({}).fitness, Fitness::bad);
  EXPECT_EQ(judge_loopback({{"lo", "127.0.0.1", true, true}}).fitness, Fitness::good);
}

TEST(Interfaces, OnesOfThisComputerHaveNameAndAddress) {
  for (const Interface& one : interfaces()) {
    EXPECT_FALSE(one.name.empty());
    EXPECT_THAT(one.address, ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_TRUE(one.up || !one.carrier) << one.name << ": no carrier without being up";
  }
}

}  // namespace
}  // namespace tocsin::doctor
