// SPDX-License-Identifier: Apache-2.0
#include "examine_security.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin::check {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::int64_t now_s = 1'795'000'000;
const std::string traffic = std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml";

class ExamineSecurityTest : public ::testing::Test {
 protected:
  ExamineSecurityTest() {
    deployment_.security = folder_.path() + "/keystore";
    deployment_.traffic = traffic;
    deployment_.radio.emplace();
    keystore::create(deployment_.security, now_s);
    for (const Role role : {Role::uxv, Role::gcs}) {
      deployment::Host host;
      host.name = host.enclave = to_string(role);
      host.role = role;
      host.containers.emplace_back().components.push_back({"link_router", "link_router", nullptr});
      deployment_.hosts.push_back(host);
      keystore::add(deployment_.security, {host.name, link_permissions({role, traffic})}, now_s);
    }
  }
  [[nodiscard]] std::vector<Finding> findings() const {
    return examine_security(deployment_, now_s);
  }
  TemporaryFolder folder_;
  deployment::Deployment deployment_;
};

TEST_F(ExamineSecurityTest, SoundIdentitiesAreNoFinding) { EXPECT_TRUE(findings().empty()); }

TEST_F(ExamineSecurityTest, AnOpenLinkIsNotLookedAt) {
  deployment_.security.clear();
  EXPECT_TRUE(findings().empty());
}

TEST_F(ExamineSecurityTest, AHostWithoutARouterNeedsNoIdentity) {
  deployment_.hosts[0].containers.clear();
  deployment_.hosts[0].enclave = "nobody";
  EXPECT_TRUE(findings().empty());
}

TEST_F(ExamineSecurityTest, AnAbsentIdentityIsAnErrorWhereBothHostsRun) {
  deployment_.hosts[0].enclave = "uxv7";
  const auto found = findings();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_THAT(found[0].text, HasSubstr("host uxv: no identity 'uxv7' in"));
}

TEST_F(ExamineSecurityTest, TheOtherHostsIdentityNeedNotBeOnThisComputer) {
  deployment_.radio.reset();
  fs::remove_all(deployment_.security + "/enclaves/gcs");
  const auto found = findings();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::note);
}

TEST_F(ExamineSecurityTest, WhatPeersWouldNotAcceptIsAnError) {
  keystore::revoke(deployment_.security, "uxv", now_s);
  const auto found = findings();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_THAT(found[0].text, AllOf(HasSubstr("host uxv: "), HasSubstr("cert.pem: is revoked")));
}

TEST_F(ExamineSecurityTest, ATopicThatThePermissionsLackIsAnErrorWithItsRemedy) {
  auto less = link_permissions({Role::uxv, traffic});
  less.publish.erase(std::find(less.publish.begin(), less.publish.end(), "rt/location"));
  keystore::permit(deployment_.security, "uxv", less);
  const auto found = findings();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].text, HasSubstr("its identity 'uxv' may not send rt/location; `tocsin "
                                       "keystore permit uxv`"));
}

TEST_F(ExamineSecurityTest, APatternAllowsWhatItFits) {
  keystore::permit(deployment_.security, "uxv", {{"rt/*"}, {"rt/*"}});
  EXPECT_TRUE(findings().empty());
}

}  // namespace
}  // namespace tocsin::check
