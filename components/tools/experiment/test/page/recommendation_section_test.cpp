// SPDX-License-Identifier: Apache-2.0
// What the report says of the policy to use, when parameters were fitted several times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/section_fixture.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Five runs, each with a fit of its own.
class RecommendationTest : public SectionTest {
 protected:
  RecommendationTest() { results_.experiment.timing.fits = 5; }
  void costs(const std::string& policy, std::vector<double> values,
             const std::string& mission = "a") {
    Group& group = add(policy, "camera", mission);
    for (std::size_t i = 0; i < values.size(); ++i) {
      group.values[i][index_of(Metric::user_cost)] = values[i];
    }
  }
};

TEST_F(RecommendationTest, NamesThePolicyThatCostsUsersLeastEverywhere) {
  for (const char* mission : {"a", "b"}) {
    costs("none", {10, 11, 12, 11, 10}, mission);
    costs("tocp_dsp", {20, 23, 22, 21, 20}, mission);
  }
  EXPECT_THAT(text(add_recommendation),
              HasSubstr("Use no policy: over 5 fits it costs users least in all 2 rounds, and less "
                        "than every other policy with 95 % confidence in 2 of them."));
}

TEST_F(RecommendationTest, ShowsTheCostOfEachFitAndTheDifference) {
  costs("none", {10, 10, 10, 10, 10});
  costs("tocp", {12, 14, 13, 12, 14});
  EXPECT_THAT(
      text(add_recommendation),
      AllOf(HasSubstr("<td>TOCP</td><td>13.0 [11.8, 14.2]</td><td>12.0</td><td>14.0</td>"),
            HasSubstr("<th>minus no policy</th>"), HasSubstr("<td>3.00 [1.76, 4.24]</td>")));
}

TEST_F(RecommendationTest, DoesNotCallClearWhatOneFitTurnsRound) {
  costs("none", {10, 10, 10, 10, 10});
  costs("tocp", {12, 30, 9, 12, 10});
  EXPECT_THAT(text(add_recommendation), HasSubstr("95 % confidence in 0 of them"));
}

TEST_F(RecommendationTest, SaysWhereAnotherPolicyIsTheBest) {
  costs("none", {10, 11, 12, 11, 10});
  costs("tocp", {20, 23, 22, 21, 20});
  costs("none", {30, 31, 32, 31, 30}, "b");
  costs("tocp", {20, 23, 22, 21, 20}, "b");
  EXPECT_THAT(text(add_recommendation),
              AllOf(HasSubstr("No policy is the best everywhere over 5 fits"),
                    HasSubstr("Mission A, channel near, payload camera: no policy"),
                    HasSubstr("Mission B, channel near, payload camera: TOCP)")));
}

TEST_F(RecommendationTest, NeedsSeveralFits) {
  costs("none", {10, 11, 12, 11, 10});
  costs("tocp", {20, 23, 22, 21, 20});
  results_.experiment.timing.fits = 1;
  EXPECT_THAT(text(add_recommendation), Not(HasSubstr("Which policy to use")));
}

}  // namespace
}  // namespace tocsin::experiment
