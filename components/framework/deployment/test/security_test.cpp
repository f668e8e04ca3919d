// SPDX-License-Identifier: Apache-2.0
// The keystore of a link.
#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::HasSubstr;

TEST_F(DeploymentTest, AnOpenLinkHasNoEnclaves) {
  const auto deployment = load(whole);
  EXPECT_EQ(deployment.security, "");
  EXPECT_EQ(enclave_of(deployment, deployment.hosts[0]), "");
}

TEST_F(DeploymentTest, ASecuredLinkHasAnEnclaveForEachHost) {
  overrides_.security = ::testing::TempDir();
  const auto deployment = load(with(whole, "role: gcs", "role: gcs\n    enclave: tower"));
  const std::string enclaves = deployment.security + "/enclaves/";
  EXPECT_EQ(enclave_of(deployment, deployment.hosts[0]), enclaves + "uxv");
  EXPECT_EQ(enclave_of(deployment, deployment.hosts[1]), enclaves + "tower");
}

TEST_F(DeploymentTest, ASecuredLinkHasDomainsUpTo228) {
  overrides_.security = ::testing::TempDir();
  EXPECT_EQ(error_of(with(whole, "domain: 40", "domain: 228")), "no error");
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: 229")),
              HasSubstr("domain: 229 is above 228, the last one of a secured link"));
}

TEST_F(DeploymentTest, RejectsAKeystoreThatIsNotThere) {
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: 40\nsecurity: ./nowhere")),
              HasSubstr("deployment.security: '"));
  overrides_.security = "/nowhere";
  EXPECT_THAT(error_of(whole), HasSubstr("--security /nowhere: is no folder"));
}

}  // namespace
}  // namespace tocsin::deployment
