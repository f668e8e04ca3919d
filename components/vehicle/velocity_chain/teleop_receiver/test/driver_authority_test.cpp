// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/driver_authority.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0{seconds(100)};

class DriverAuthorityTest : public ::testing::Test {
 protected:
  /// Drives at 10 Hz up to that second; how many commands were followed.
  int drive(const std::string& name, double until_s) {
    int followed = 0;
    for (; now_ < t0 + seconds(until_s); now_ += seconds(0.1)) {
      followed += sut_.follows(name, now_) ? 1 : 0;
    }
    return followed;
  }
  DriverAuthority sut_{DriverAuthority::Params{}};
  Time now_ = t0;
};

TEST_F(DriverAuthorityTest, TheFirstToDriveIsFollowed) {
  EXPECT_FALSE(sut_.driver());
  EXPECT_EQ(sut_.next_deadline(), never);
  EXPECT_TRUE(sut_.follows("anna", t0));
  EXPECT_EQ(sut_.driver(), "anna");
  EXPECT_EQ(sut_.next_deadline(), t0 + seconds(2));
}

TEST_F(DriverAuthorityTest, AnotherIsRefusedWhileHeDrives) {
  drive("anna", 1);
  EXPECT_FALSE(sut_.follows("ben", now_));
  EXPECT_FALSE(sut_.follows("", now_)) << "who has no name is somebody, too";
  EXPECT_EQ(sut_.refused(), 2U);
  EXPECT_TRUE(sut_.follows("anna", now_));
}

TEST_F(DriverAuthorityTest, WhoLetsGoForAWhileLeavesControlToTheNext) {
  drive("anna", 1);
  EXPECT_FALSE(sut_.follows("ben", now_ + seconds(1.8)));
  EXPECT_TRUE(sut_.follows("ben", now_ + seconds(2)));
  EXPECT_EQ(sut_.driver(), "ben");
}

TEST_F(DriverAuthorityTest, TheDriverAloneGivesControlToWhoAskedFirst) {
  drive("anna", 1);
  for (const char* name : {"ben", "carl", "anna"}) sut_.ask(name, now_);
  EXPECT_EQ(sut_.asked_by(), "ben");
  for (const char* name : {"ben", "carl"}) sut_.give(name, now_);
  EXPECT_TRUE(sut_.follows("anna", now_)) << "until she answers";
  sut_.give("anna", now_);
  EXPECT_EQ(sut_.driver(), "ben");
  EXPECT_FALSE(sut_.asked_by());
  EXPECT_FALSE(sut_.follows("anna", now_));
  EXPECT_TRUE(sut_.follows("ben", now_ + seconds(1.9)));
}

TEST_F(DriverAuthorityTest, ControlThatIsFreeIsOfWhoAsks) {
  sut_.ask("anna", t0);
  EXPECT_EQ(sut_.driver(), "anna");
  EXPECT_FALSE(sut_.follows("ben", t0 + seconds(1)));
  sut_.give("anna", t0 + seconds(1));
  EXPECT_FALSE(sut_.driver());
  EXPECT_TRUE(sut_.follows("ben", t0 + seconds(1)));
}

TEST_F(DriverAuthorityTest, WhoDoesNotAnswerLosesIt) {
  drive("anna", 1);
  sut_.ask("ben", now_);
  EXPECT_EQ(drive("anna", 10.95), 100);
  EXPECT_EQ(sut_.driver(), "anna");
  EXPECT_EQ(drive("anna", 12), 0);
  EXPECT_EQ(sut_.driver(), "ben");
}

TEST_F(DriverAuthorityTest, WhoKeepsItIsNotOverruled) {
  drive("anna", 1);
  sut_.ask("ben", now_);
  sut_.keep("ben");
  EXPECT_TRUE(sut_.asked_by()) << "only the driver can";
  sut_.keep("anna");
  EXPECT_FALSE(sut_.asked_by());
  EXPECT_EQ(drive("anna", 31), 300);
}

TEST_F(DriverAuthorityTest, ADriverWhoLetsGoWhileAskedHandsOver) {
  drive("anna", 1);
  sut_.ask("ben", now_);
  sut_.settle(now_ + seconds(2));
  EXPECT_EQ(sut_.driver(), "ben");
  sut_.settle(now_ + seconds(4));
  EXPECT_FALSE(sut_.driver()) << "he does not drive either";
}

TEST_F(DriverAuthorityTest, ASupervisorTakesItAtOnceAndWhoAskedStillWaits) {
  drive("anna", 1);
  sut_.ask("ben", now_);
  sut_.take("carl", now_);
  EXPECT_EQ(sut_.driver(), "carl");
  EXPECT_FALSE(sut_.follows("anna", now_));
  EXPECT_TRUE(sut_.follows("carl", now_ + seconds(1.9)));
  EXPECT_EQ(sut_.asked_by(), "ben");
  sut_.take("ben", now_ + seconds(1.9));
  EXPECT_EQ(sut_.driver(), "ben");
  EXPECT_FALSE(sut_.asked_by());
}

}  // namespace
}  // namespace tocsin
