// SPDX-License-Identifier: Apache-2.0
// Policies whose laws are learned while they decide: a building that is another one, one that
// drifts, faults while learning.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ar1_feed.hpp"
#include "decision/policy.hpp"

namespace tocsin::decision {
namespace {

PolicyParams with_laws(const char* laws, const char* policy = "tocp_reverse") {
  PolicyParams params;
  params.policy = policy;
  params.laws = laws;
  return params;
}

/// Drives a policy with one sample a second and counts.
class Drive {
 public:
  explicit Drive(const PolicyParams& params) : policy_(make_policy(params)) {}
  Evidence take(double qni) {
    now_ += std::chrono::seconds(1);
    const Evidence evidence = policy_->on_sample({now_, qni}, now_);
    pauses += evidence.changed && evidence.state == State::passive;
    silent += evidence.state == State::passive;
    return evidence;
  }
  void take(Ar1Feed& link, const Normal& law, int samples) {
    for (int i = 0; i < samples; ++i) take(std::clamp(link.next(law), 0.0, 100.0));
  }
  /// Samples of a dead link until it is silent.
  int delay(Ar1Feed& link) {
    for (int i = 1; i < 1000; ++i) {
      if (take(link.next(thesis_bad)).state == State::passive) return i;
    }
    return 1000;
  }
  [[nodiscard]] LearnedLaw learned() const { return policy_->learned().value(); }
  [[nodiscard]] bool learns() const { return policy_->learned().has_value(); }

  int pauses = 0;
  int silent = 0;

 private:
  std::unique_ptr<Policy> policy_;
  Time now_{std::chrono::hours(1)};
};

TEST(LearningPolicy, DecidesAsWithFixedLawsWhenItOnlyProposes) {
  for (const char* name : {"none", "threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief"}) {
    Drive fixed(with_laws("fixed", name));
    Drive sut(with_laws("propose", name));
    Ar1Feed link(0.8);
    for (int i = 0; i < 5000; ++i) {
      const double quality = std::clamp(link.next({65, 18}), 0.0, 100.0);
      const Evidence expected = fixed.take(quality);
      const Evidence evidence = sut.take(quality);
      ASSERT_EQ(evidence.state, expected.state) << name << ' ' << i;
      ASSERT_EQ(evidence.statistic, expected.statistic) << name << ' ' << i;
      ASSERT_EQ(evidence.threshold, expected.threshold) << name << ' ' << i;
    }
    EXPECT_FALSE(fixed.learns());
    EXPECT_TRUE(sut.learns());
    EXPECT_EQ(sut.learned().in_force.mean, thesis_good.mean);
  }
}

TEST(LearningPolicy, HasTheFalseAlarmsThatAreWantedInAnotherBuilding) {
  constexpr Normal building{70, 9};
  Drive fixed(with_laws("fixed"));
  Drive sut(with_laws("apply"));
  Ar1Feed first(0);
  Ar1Feed second(0);
  fixed.take(first, building, 20000);
  sut.take(second, building, 20000);
  fixed.pauses = sut.pauses = 0;
  fixed.take(first, building, 360000);  // 100 at the wanted rate
  sut.take(second, building, 360000);
  EXPECT_GT(fixed.pauses, 400);
  EXPECT_GT(sut.pauses, 50);
  EXPECT_LT(sut.pauses, 200);
}

TEST(LearningPolicy, FollowsABuildingThatDrifts) {
  Drive fixed(with_laws("fixed"));
  Drive sut(with_laws("apply"));
  Ar1Feed first(0.5);
  Ar1Feed second(0.5);
  constexpr int hours = 8;
  for (int i = 0; i < hours * 3600; ++i) {
    const Normal law{81.6 - 14.0 * i / (hours * 3600), 10.3};  // to 67.6
    fixed.take(first, law, 1);
    sut.take(second, law, 1);
  }
  EXPECT_NEAR(sut.learned().in_force.mean, 67.6, 4);
  EXPECT_LT(sut.pauses, fixed.pauses / 2);
}

TEST(LearningPolicy, FindsADeadLinkAsFastAsWithFixedLaws) {
  for (const Normal building : {thesis_good, Normal{70, 7}, Normal{90, 5}}) {
    Drive fixed(with_laws("fixed"));
    Drive sut(with_laws("apply"));
    Ar1Feed first(0);
    Ar1Feed second(0);
    int expected = 0;
    int found = 0;
    fixed.take(first, building, 10000);
    sut.take(second, building, 10000);
    for (int i = 0; i < 50; ++i) {
      fixed.take(first, building, 100);
      sut.take(second, building, 100);
      expected += fixed.delay(first);
      found += sut.delay(second);
    }
    EXPECT_LE(found, expected + 10) << building.mean;  // 50 falls
  }
}

TEST(LearningPolicy, IsNotTaughtByAFaultWhileItLearns) {
  Drive sut(with_laws("apply"));
  Ar1Feed link(0.5);
  sut.take(link, thesis_good, 600);
  sut.take(link, thesis_bad, 3600);  // an hour
  EXPECT_NEAR(sut.learned().in_force.mean, thesis_good.mean, 1e-9);
  const int before = sut.silent;
  sut.take(link, thesis_bad, 3600);
  EXPECT_GT(sut.silent - before, 3000);  // silent but for the forced slots
}

TEST(LearningPolicy, DoesNotNarrowItsLawRoundByRoundOnACorrelatedLink) {
  Drive sut(with_laws("apply"));
  Ar1Feed link(0.95);
  sut.take(link, thesis_good, 200000);
  EXPECT_GT(sut.learned().learned.sd, 0.7 * thesis_good.sd);
  EXPECT_NEAR(sut.learned().learned.mean, thesis_good.mean, 0.7 * thesis_good.sd);
}

TEST(LearningPolicy, ChangesTheLawOnlyWhileActiveAndQuiet) {
  PolicyParams params = with_laws("apply");
  params.learn_memory_samples = 100;
  Drive sut(params);
  Ar1Feed link(0.5);
  double threshold = params.alpha;
  unsigned applied = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool good = i % 400 < 300;
    const Evidence evidence = sut.take(link.next(good ? Normal{70, 7} : thesis_bad));
    const unsigned now = sut.learned().applied;
    if (now == applied) continue;
    applied = now;
    EXPECT_EQ(evidence.state, State::active);
    EXPECT_FALSE(evidence.changed);
    EXPECT_LE(evidence.statistic, evidence.threshold / 4);
    EXPECT_EQ(evidence.threshold,
              threshold);  // what it was compared with; the next has the new one
    threshold = sut.take(80).threshold;
  }
  EXPECT_GT(applied, 0U);
}

TEST(LearningPolicy, StandsWhateverComes) {
  for (const char* detector : {"cusum", "focus", "shiryaev_roberts"}) {
    PolicyParams params = with_laws("apply", "tocp_dsp");
    params.detector = detector;
    params.bad_mean = 75;  // the learned law may come below it
    params.learn_memory_samples = 60;
    Drive sut(params);
    for (int i = 0; i < 20000; ++i) {
      const double values[] = {0, 100, NAN, INFINITY, -INFINITY, 1e300, 76, 77, 78, 70};
      EXPECT_NO_THROW((void)sut.take(values[(i * 7 + i / 500) % 10]));
    }
    const LearnedLaw law = sut.learned();
    EXPECT_TRUE(std::isfinite(law.learned.mean) && law.learned.sd > 0) << detector;
    EXPECT_GT(law.in_force.mean, params.bad_mean) << detector;
  }
}

}  // namespace
}  // namespace tocsin::decision
