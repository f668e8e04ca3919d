// SPDX-License-Identifier: Apache-2.0
#include "decision/cusum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

// Values of the corrected equation (29) for the thesis's laws, computed independently.
TEST(NormalLlr, HasTheKnownValues) {
  const NormalLlr sut;
  EXPECT_NEAR(sut(0), 19.21444456798172, 1e-10);
  EXPECT_NEAR(sut(36.599), 9.809356237955019, 1e-10);
  EXPECT_NEAR(sut(57), -0.6553302743757392, 1e-10);
  EXPECT_NEAR(sut(81.5669), -18.217949317773186, 1e-10);
  EXPECT_NEAR(sut(100), -34.95505617117938, 1e-10);
}

TEST(NormalLlr, ChangesSignAtTheKnownQuality) {
  const NormalLlr sut;
  EXPECT_GT(sut(55.9071), 0);
  EXPECT_LT(sut(55.9072), 0);
}

TEST(NormalLlr, FallsMonotonicallyOverAllQualities) {
  for (const auto& sut :
       {NormalLlr{}, NormalLlr({80, 20}, {40, 5}), NormalLlr({80, 5}, {40, 20})}) {
    for (int x = 0; x < 100; ++x) EXPECT_GE(sut(x), sut(x + 1)) << x;
  }
}

TEST(NormalLlr, NeverCountsVeryLowQualityAsGood) {
  const NormalLlr sut({80, 20}, {40, 5});
  EXPECT_GT(sut(0), 0);
  EXPECT_EQ(sut(0), sut(30));
}

TEST(NormalLlr, IsBoundedByItsClip) {
  const NormalLlr sut(thesis_good, thesis_bad, 4);
  EXPECT_EQ(sut(0), 4);
  EXPECT_EQ(sut(100), -4);
  EXPECT_NEAR(sut(55), 0.5358378611317356, 1e-10);
}

TEST(NormalLlr, RejectsLawsThatMakeNoSense) {
  EXPECT_THROW(NormalLlr({80, 0}, {40, 5}), ConfigError);
  EXPECT_THROW(NormalLlr({80, 5}, {40, -1}), ConfigError);
  EXPECT_THROW(NormalLlr({80, NAN}, {40, 5}), ConfigError);
  EXPECT_THROW(NormalLlr({40, 5}, {40, 5}), ConfigError);
  EXPECT_THROW(NormalLlr({80, 5}, {40, 5}, -1), ConfigError);
}

TEST(Cusum, SumsAndNeverFallsBelowZero) {
  Cusum sut;
  EXPECT_EQ(sut.add(-3), 0);
  EXPECT_EQ(sut.add(2), 2);
  EXPECT_EQ(sut.add(1.5), 3.5);
  EXPECT_EQ(sut.add(-1), 2.5);
  EXPECT_EQ(sut.add(-9), 0);
}

TEST(Cusum, AlarmsAtTheThresholdNotBelow) {
  Cusum sut;
  sut.add(5);
  EXPECT_TRUE(sut.alarm(5));
  EXPECT_FALSE(sut.alarm(5.0000001));
}

TEST(Cusum, TellsHowLongAgoTheChangeWas) {
  Cusum sut;
  for (const double l : {-1.0, 2.0, -0.5, 3.0}) sut.add(l);
  EXPECT_EQ(sut.run(), 3U);
  sut.add(-10);
  EXPECT_EQ(sut.run(), 0U);
}

TEST(Cusum, IgnoresNan) {
  Cusum sut;
  sut.add(2);
  EXPECT_EQ(sut.add(NAN), 2);
  EXPECT_EQ(sut.run(), 1U);
}

TEST(Cusum, FitsAMillionTimesIn64Megabytes) { EXPECT_LE(sizeof(Cusum), 16U); }

void follow(const char* name) {
  const auto path = golden_file(name);
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table t = read_table(path);
  const NormalLlr llr;
  Cusum running;
  Cusum resetting;
  Deviations numbers;
  Deviations alarms;
  for (std::size_t n = 0; n < t.rows; ++n) {
    const double l = llr(t.columns["qni"][n]);
    numbers.relative(l, t.columns["llr"][n], 1e-9);
    numbers.relative(running.add(l), t.columns["W"][n], 1e-9);
    numbers.relative(resetting.add(l), t.columns["W_reset"][n], 1e-9);
    alarms.exact(resetting.alarm(5.53), t.columns["alarm"][n] > 0.5);
    if (resetting.alarm(5.53)) resetting.reset();
  }
  std::cout << name << " statistics: " << numbers.summary() << "; alarms: " << alarms.summary()
            << '\n';
  EXPECT_EQ(numbers.outside(), 0);
  EXPECT_EQ(alarms.outside(), 0);
  EXPECT_EQ(numbers.compared(), 4500);
}

TEST(Cusum, FollowsGoldenTrace1) { follow("trace1_iid.csv"); }
TEST(Cusum, FollowsGoldenTrace2) { follow("trace2_ar_ramp.csv"); }

}  // namespace
}  // namespace tocsin::decision
