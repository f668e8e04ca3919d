// SPDX-License-Identifier: Apache-2.0
// Cyclone DDS with identities of our keystore on a secured link; a slice of `strangers`.
#include <gtest/gtest.h>
#include <unistd.h>

#include "runtime/fast_dds/version.hpp"
#include "strangers.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;

constexpr auto in_time = milliseconds(2000);  // in which the right one must join

class Strangers : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { has_network = enter_own_network(); }
  void SetUp() override {
    if (!has_network) GTEST_SKIP() << "no right to make a network namespace";
  }
  static bool has_network;
  const Identities identities_;
};
bool Strangers::has_network = false;

TEST_F(Strangers, CycloneWithAnIdentityOfOursJoinsWritesAndReads) {
  if (fast_dds::version >= 3) GTEST_SKIP() << "Cyclone DDS does not join Fast DDS 3 (SECURITY.md)";
  Link sut(&identities_);
  const Reached reached = sut.attempt({"cyclone", Role::uxv, identities_.good("rover"), in_time});
  EXPECT_EQ(reached.failed, 0);
  EXPECT_GT(reached.joined, 0);
  EXPECT_GT(reached.commanded, 0);
  EXPECT_LT(reached.heard_ms, in_time.count());
  EXPECT_GT(reached.read, 0U);
  EXPECT_EQ(reached.disturbed, 0);
}

TEST_F(Strangers, CycloneWithoutOrWithAWrongIdentityReachesNothing) {
  Link sut(&identities_);
  for (const std::string& enclave :
       {std::string(), identities_.other("rover"), identities_.revoked()}) {
    for (int i = 0; i < 2; ++i) {
      const Reached reached = sut.attempt({"cyclone", Role::uxv, enclave, in_time / 2});
      EXPECT_EQ(reached.failed, 0) << enclave;
      EXPECT_EQ(reached.joined, 0) << enclave;
      EXPECT_EQ(reached.commanded, 0) << enclave;
      EXPECT_EQ(reached.read, 0U) << enclave;
    }
  }
  EXPECT_LT(sut.rejoin(), 2000);
}

TEST_F(Strangers, OfAPlainLinkEverybodyReachesAll) {
  Link sut(nullptr);
  for (const char* const maker : {"fast_dds", "cyclone"}) {
    const Reached reached = sut.attempt({maker, Role::uxv, "", in_time});
    EXPECT_GT(reached.joined, 0) << maker;
    EXPECT_GT(reached.commanded, 0) << maker;
    EXPECT_GT(reached.read, 0U) << maker;
  }
}

}  // namespace
}  // namespace tocsin::interop
