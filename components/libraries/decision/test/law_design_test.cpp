// SPDX-License-Identifier: Apache-2.0
#include "law_design.hpp"

#include <gtest/gtest.h>

#include "decision/policy_model.hpp"

namespace tocsin::decision {
namespace {

PolicyParams reverse() {
  PolicyParams params;
  params.policy = "tocp_reverse";
  params.laws = "apply";
  return params;
}

double false_alarms(const PolicyParams& p) {
  return mean_run_length(step_law_of(p, good_law_of(p)), p.alpha, p.llr_clip == 0);
}

double false_resumes(const PolicyParams& p) {
  return mean_run_length(reverse_step_law_of(p, bad_law_of(p)), p.reverse_alpha, p.llr_clip == 0);
}

TEST(LawDesign, KeepsTheThresholdsForTheConfiguredLaw) {
  const PolicyParams params = reverse();
  const auto sut = LawDesign(params).for_good(thesis_good);
  ASSERT_TRUE(sut);
  EXPECT_NEAR(sut->alpha / params.alpha, 1, 0.01);
  EXPECT_NEAR(sut->reverse_alpha / params.reverse_alpha, 1, 0.01);
  EXPECT_DOUBLE_EQ(sut->mild_mean, params.mild_mean);
}

TEST(LawDesign, KeepsTheTimesBetweenFalseAlarmsAndResumesForOtherLaws) {
  const PolicyParams params = reverse();
  const LawDesign sut(params);
  for (const Normal law : {Normal{70, 9}, Normal{75, 14}, Normal{66, 6}, Normal{84, 12}}) {
    const auto found = sut.for_good(law);
    ASSERT_TRUE(found);
    EXPECT_NEAR(false_alarms(*found) / false_alarms(params), 1, 0.05) << law.mean;
    EXPECT_NEAR(false_resumes(*found) / false_resumes(params), 1, 0.05) << law.mean;
  }
}

TEST(LawDesign, HasNoMoreFalseAlarmsWithClippedRatiosWhoseTimesJump) {
  PolicyParams params = reverse();
  params.llr_clip = 4;
  params.alpha = 6.9;
  const auto sut = LawDesign(params).for_good({72, 9});
  ASSERT_TRUE(sut);
  EXPECT_GE(false_alarms(*sut) / false_alarms(params), 0.75);  // atoms on a coarse lattice
}

TEST(LawDesign, KeepsTheThresholdWhereAllHaveFewerFalseAlarms) {
  const PolicyParams params = reverse();
  const auto sut = LawDesign(params).for_good({90, 5});
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->alpha, params.alpha);
  EXPECT_GT(false_alarms(*sut), false_alarms(params));
}

TEST(LawDesign, RefusesAGoodLawThatIsNotAboveTheBadOne) {
  const LawDesign sut(reverse());
  EXPECT_FALSE(sut.for_good({36.5, 5}));
  EXPECT_FALSE(sut.for_good({NAN, 5}));
  EXPECT_FALSE(sut.for_good({80, 0}));
}

TEST(LawDesign, MovesTheOtherDetectorsWithTheLaw) {
  PolicyParams params = reverse();
  params.mild_share = 0.5;
  params.mild_mean = thesis_good.mean - thesis_good.sd;
  const auto mild = LawDesign(params).for_good({74, 7});
  ASSERT_TRUE(mild);
  EXPECT_NEAR(mild->mild_mean, 67, 1e-9);
  EXPECT_EQ(mild->mild_alpha, mild_alpha_of(params));  // exact: in spreads it is the same test
  EXPECT_EQ(mild->mild_share, 0);
  params = reverse();
  params.detector = "focus";
  const LawDesign focus(params);
  EXPECT_EQ(focus.for_good({74, 7})->detector_threshold,
            focus.for_good({80, 9})->detector_threshold);
  params.detector = "shiryaev_roberts";
  const double before = detector_threshold_of(params);
  const auto roberts = LawDesign(params).for_good({74, 12});
  EXPECT_NEAR(roberts->detector_threshold - before, roberts->alpha - params.alpha, 1e-9);
}

}  // namespace
}  // namespace tocsin::decision
