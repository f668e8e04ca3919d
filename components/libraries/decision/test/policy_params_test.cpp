// SPDX-License-Identifier: Apache-2.0
#include "decision/policy_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "policy_feed.hpp"

namespace tocsin::decision {
namespace {

std::string error_of(const std::string& yaml) {
  try {
    (void)make_policy(load_parameters<PolicyParams>(YAML::Load(yaml), "policy", "p.yaml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PolicyParams, AcceptTheirDefaults) { EXPECT_EQ(error_of(""), "no error"); }

TEST(PolicyParams, PauseNothingByDefault) { EXPECT_EQ(PolicyParams{}.policy, PolicyKind::none); }

TEST(PolicyParams, RejectContradictions) {
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of("{pause_below_qni: 60}"), HasSubstr("pause_below_qni: 60 must be at most"));
  EXPECT_EQ(error_of("{pause_below_qni: 50}"), "no error");
  EXPECT_THAT(error_of("{policy: tocp, fixed_pause_samples: 31}"), HasSubstr("at most th_max"));
  EXPECT_THAT(error_of("{policy: tocp_dsp, discount_value: 0}"), HasSubstr("discount_value: 0"));
  EXPECT_EQ(error_of("{policy: tocp_dsp, discount_value: 0, discount: linear}"), "no error");
  EXPECT_THAT(error_of("{bad_mean: 90}"), HasSubstr("must be above that of the bad law"));
  EXPECT_THAT(error_of("{good_family: cauchy}"), HasSubstr("'cauchy' is not one of: normal"));
  EXPECT_THAT(error_of("{good_family: beta, good_parameters: [1]}"), HasSubstr("beta has a b"));
  EXPECT_THAT(error_of("{policy: tocp, false_alarm_samples: 100}"), HasSubstr("must be above 153"));
  EXPECT_THAT(error_of("{policy: belief, cost_silent_bad: 1}"), HasSubstr("below cost_send_bad"));
  EXPECT_THAT(
      error_of("{policy: tocp, detector: focus, good_family: beta, good_parameters: [9, 2]}"),
      HasSubstr("focus needs a normal good law, not beta"));
  EXPECT_THAT(error_of("{policy: magic}"), HasSubstr("'magic' is not one of"));
  EXPECT_THAT(error_of("{policy: tocp_dps}"), HasSubstr("did you mean 'tocp_dsp'?"));
}

}  // namespace
}  // namespace tocsin::decision
