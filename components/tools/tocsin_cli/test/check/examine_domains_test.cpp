// SPDX-License-Identifier: Apache-2.0
#include "examine_domains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;

std::vector<Finding> findings_of(int local_domain, int link_domain) {
  deployment::Deployment deployment;
  deployment.hosts.emplace_back().name = "uxv";
  deployment.hosts.front().local_domain = local_domain;
  deployment.link_domain = link_domain;
  return examine_domains(deployment);
}

TEST(ExamineDomains, WarnsFromTheFirstDomainWhosePortsAnybodyMayHave) {
  EXPECT_TRUE(findings_of(101, 2).empty());
  const auto findings = findings_of(102, 2);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, Severity::warning);
  EXPECT_THAT(findings[0].text, HasSubstr("domain 102 of uxv: its ports, from 32900,"));
}

TEST(ExamineDomains, WarnsUpToTheLastDomainWhosePortsAnybodyMayHave) {
  EXPECT_TRUE(findings_of(0, 215).empty());
  const auto findings = findings_of(0, 214);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].text, HasSubstr("domain 214 of the link"));
}

}  // namespace
}  // namespace tocsin::check
