// SPDX-License-Identifier: Apache-2.0
#include "link_router/site_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class SiteChoiceTest : public ::testing::Test {
 protected:
  /// For so long, ten times a second, these are heard. How often another one was chosen.
  int hear(std::initializer_list<const char*> sites, Duration length) {
    int changes = 0;
    for (const Time end = now_ + length; now_ < end; now_ += milliseconds(100)) {
      for (const char* const site : sites) sut_.on_heard(site, now_);
      changes += sut_.follow(now_) ? 1 : 0;
    }
    return changes;
  }
  SiteChoice sut_{{"north", "middle", "south"}};
  Time now_{std::chrono::hours(1)};
};

TEST_F(SiteChoiceTest, BeginsWithTheFirstAndStaysWhileAllAreHeard) {
  EXPECT_EQ(sut_.chosen(), "north");
  EXPECT_THAT(sut_.others(), ElementsAre("middle", "south"));
  EXPECT_EQ(hear({"north", "middle", "south"}, seconds(60)), 0);
  EXPECT_EQ(sut_.chosen(), "north");
}

TEST_F(SiteChoiceTest, GoesToTheNextOneThatIsHeardWithinSixTenthsOfASecond) {
  (void)hear({"north", "south"}, seconds(1));
  EXPECT_EQ(hear({"south"}, milliseconds(400)), 0);
  EXPECT_EQ(hear({"south"}, milliseconds(200)), 1);
  EXPECT_EQ(sut_.chosen(), "south") << "the second is not heard";
}

TEST_F(SiteChoiceTest, StaysWhereNobodyElseIsHeard) {
  (void)hear({"north"}, seconds(1));
  EXPECT_EQ(hear({}, seconds(60)), 0);
  EXPECT_EQ(sut_.chosen(), "north");
  EXPECT_EQ(hear({"middle"}, milliseconds(300)), 0);
  EXPECT_EQ(hear({"middle"}, milliseconds(100)), 1) << "then it takes who is there";
  EXPECT_EQ(sut_.chosen(), "middle");
}

TEST_F(SiteChoiceTest, AnOutageOfTheRadioChangesNothingWhoeverIsHeardFirstAfterIt) {
  (void)hear({"north", "south"}, seconds(1));
  EXPECT_EQ(hear({}, seconds(10)), 0);
  EXPECT_EQ(hear({"south"}, milliseconds(200)), 0);
  EXPECT_EQ(hear({"north", "south"}, seconds(10)), 0);
}

TEST_F(SiteChoiceTest, ReturnsToAPreferredOneThatIsHeardForFiveSecondsWithoutAGap) {
  (void)hear({"south"}, seconds(2));
  ASSERT_EQ(sut_.chosen(), "south");
  EXPECT_EQ(hear({"north", "south"}, milliseconds(4500)), 0);
  EXPECT_EQ(hear({"south"}, milliseconds(700)), 0);
  EXPECT_EQ(hear({"north", "south"}, milliseconds(4900)), 0) << "it counts anew";
  EXPECT_EQ(hear({"north", "south"}, milliseconds(300)), 1);
  EXPECT_EQ(sut_.chosen(), "north");
}

TEST_F(SiteChoiceTest, DoesNotGoToOneThatComesAfterIt) {
  EXPECT_EQ(hear({"north", "middle"}, seconds(20)), 0);
}

TEST_F(SiteChoiceTest, AtItsStartTheFirstHasTimeToBeHeard) {
  EXPECT_EQ(hear({"south"}, milliseconds(500)), 0);
  EXPECT_EQ(hear({"north", "south"}, seconds(20)), 0);
}

TEST_F(SiteChoiceTest, AFreezeOfItsOwnProcessIsNoSilenceOfTheSite) {
  (void)hear({"north", "south"}, seconds(1));
  now_ += seconds(5);
  sut_.on_heard("south", now_);
  EXPECT_FALSE(sut_.follow(now_));
  EXPECT_EQ(hear({"north", "south"}, seconds(1)), 0);
}

TEST_F(SiteChoiceTest, OthersThanItsSitesDoNotCount) {
  (void)hear({"stranger"}, seconds(10));
  EXPECT_EQ(sut_.chosen(), "north");
}

TEST(SiteChoice, WithOneSiteOrNoneThereIsNothingToChoose) {
  for (const std::vector<std::string>& sites : {std::vector<std::string>{}, {"gcs"}}) {
    SiteChoice sut(sites);
    sut.on_heard("gcs", Time(seconds(1)));
    EXPECT_FALSE(sut.follow(Time(seconds(10))));
    EXPECT_EQ(sut.chosen(), "");
    EXPECT_THAT(sut.others(), IsEmpty());
  }
}

}  // namespace
}  // namespace tocsin::router
