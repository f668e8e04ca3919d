// SPDX-License-Identifier: Apache-2.0
#include "examine_routers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graphs.hpp"

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;

deployment::Host host(const std::string& name, const std::string& address,
                      const std::vector<std::string>& peers) {
  deployment::Host one;
  one.name = name;
  one.address = address;
  one.peers = peers;
  one.containers.emplace_back().name = "link";
  return one;
}

/// A vehicle and a station that are each other's peers, both without a router.
deployment::Deployment two_hosts() {
  deployment::Deployment deployment;
  deployment.hosts = {host("uxv", "10.0.0.1", {"10.0.0.2"}), host("gcs", "10.0.0.2", {"10.0.0.1"})};
  return deployment;
}

void add_router(deployment::Host& host, const std::string& name = "link_router") {
  host.containers.front().components.push_back({"link_router", name, nullptr});
}

/// The vehicle tells its place over the link; the station has host topics only.
Graph talking_vehicle() {
  return {vehicle("navigator", {writes("location", Scope::link)}),
          station("view", {reads("odom")})};
}

TEST(ExamineRouters, OneOnEachHostIsRight) {
  auto deployment = two_hosts();
  for (auto& one : deployment.hosts) add_router(one);
  EXPECT_TRUE(examine_routers(deployment, talking_vehicle()).empty());
}

TEST(ExamineRouters, TwoOnOneHostAreAnErrorThatNamesBoth) {
  auto deployment = two_hosts();
  for (auto& one : deployment.hosts) add_router(one);
  add_router(deployment.hosts[0], "second");
  const auto findings = examine_routers(deployment, talking_vehicle());
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::error);
  EXPECT_THAT(findings[0].text, HasSubstr("uxv/link/link_router and uxv/link/second"));
}

TEST(ExamineRouters, APeerWithoutOneIsAnErrorAndNoWarning) {
  for (const std::size_t routed : {0U, 1U}) {
    auto deployment = two_hosts();
    add_router(deployment.hosts[routed]);
    const auto findings = examine_routers(deployment, talking_vehicle());
    ASSERT_EQ(findings.size(), 1U) << routed;
    EXPECT_EQ(findings[0].severity, Severity::error);
    const std::string lacking = deployment.hosts[1 - routed].name;
    EXPECT_THAT(findings[0].text, HasSubstr("host " + lacking + " has no link_router"));
    EXPECT_THAT(findings[0].text, HasSubstr("to a container of " + lacking));
  }
}

TEST(ExamineRouters, LinkTopicsThatNoRouterCarriesAreAnError) {
  const auto findings = examine_routers(two_hosts(), talking_vehicle());
  ASSERT_EQ(findings.size(), 1U) << "the station has no link topics";
  EXPECT_EQ(findings[0].severity, Severity::error);
  EXPECT_THAT(findings[0].text, HasSubstr("host uxv: no link_router carries the link topics of "
                                          "uxv/drive/navigator: they stay on"));
  EXPECT_THAT(findings[0].text, HasSubstr("add the component link_router"));
}

TEST(ExamineRouters, AHostWithoutPeersNeedsNone) {
  auto deployment = two_hosts();
  deployment.hosts.pop_back();
  EXPECT_EQ(examine_routers(deployment, talking_vehicle()).size(), 1U) << "peer of another file";
  deployment.hosts[0].peers.clear();
  EXPECT_TRUE(examine_routers(deployment, talking_vehicle()).empty());
}

}  // namespace
}  // namespace tocsin::check
