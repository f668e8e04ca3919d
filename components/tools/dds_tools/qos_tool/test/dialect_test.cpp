// SPDX-License-Identifier: Apache-2.0
// The tables of what other vendors' files say: whole, without contradiction, and in our words.
#include "dialect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "policy_values.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {
namespace {

std::set<std::string> policies() {
  std::set<std::string> all;
  for (const PolicyValue& one : values_of(QosProfile())) all.insert(one.policy);
  return all;
}

bool has_place(Vendor vendor, const std::string& policy) {
  for (const bool writer : {true, false}) {
    const auto& all = places(vendor, writer);
    if (std::any_of(all.begin(), all.end(),
                    [&](const Place& place) { return place.policy == policy; })) {
      return true;
    }
  }
  return false;
}

class DialectTest : public ::testing::TestWithParam<Vendor> {
 protected:
  /// Calls `look` for each place of both ends.
  template <class Look>
  void for_each_place(Look look) {
    for (const bool writer : {true, false}) {
      for (const Place& place : places(GetParam(), writer)) look(place, writer);
    }
  }
};

TEST_P(DialectTest, APolicyHasAPlaceOrAReasonWhyItIsLost) {
  // What the two ends ask of each other, the vendors say in one element for each end.
  const std::set<std::string> said_elsewhere{"requested_reliability"};
  ASSERT_GT(policies().size(), 25U);
  for (const std::string& policy : policies()) {
    if (said_elsewhere.count(policy) != 0) continue;
    EXPECT_NE(has_place(GetParam(), policy), !why_lost(GetParam(), policy).empty()) << policy;
  }
}

TEST_P(DialectTest, APlaceIsOfAPolicyThatThereIs) {
  const auto known = policies();
  for_each_place([&](const Place& place, bool) {
    const std::string policy = place.policy;
    EXPECT_TRUE(policy.empty() || known.count(policy) == 1) << policy;
  });
  EXPECT_EQ(why_lost(GetParam(), "no_such_policy"), "");
}

INSTANTIATE_TEST_SUITE_P(Vendors, DialectTest,
                         ::testing::Values(Vendor::fast_dds, Vendor::fast_dds_3, Vendor::cyclone));

}  // namespace
}  // namespace tocsin::qos_tool
