// SPDX-License-Identifier: Apache-2.0
#include "open_link.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;

deployment::Deployment routed(const std::string& address) {
  deployment::Deployment deployment;
  deployment.hosts.resize(1);
  deployment::Host& host = deployment.hosts[0];
  host.name = "uxv";
  host.address = address;
  host.containers = {{"link", false, {{"link_router", "link_router", nullptr}}}};
  return deployment;
}

TEST(OpenLink, ARealInterfaceWithoutKeystoreIsSaid) {
  const auto warning = open_link_warning(routed("10.1.2.3"));
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, HasSubstr("WARN: the link of uxv (10.1.2.3) is open"));
  EXPECT_THAT(*warning, HasSubstr("tocsin keystore create"));
  EXPECT_EQ(warning->find('\n'), std::string::npos);
}

TEST(OpenLink, AKeystoreLoopbackAnEmulatedRadioAndAHostWithoutRouterAreNot) {
  auto secured = routed("10.1.2.3");
  secured.security = "/keys";
  EXPECT_FALSE(open_link_warning(secured));
  EXPECT_FALSE(open_link_warning(routed("127.0.0.1")));
  auto emulated = routed("10.1.2.3");
  emulated.radio = deployment::Radio{"/c.yaml", "/w.yaml"};
  EXPECT_FALSE(open_link_warning(emulated));
  auto alone = routed("10.1.2.3");
  alone.hosts[0].containers.clear();
  EXPECT_FALSE(open_link_warning(alone));
}

}  // namespace
}  // namespace tocsin::cli
