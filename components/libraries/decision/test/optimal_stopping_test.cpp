// SPDX-License-Identifier: Apache-2.0
#include "decision/research/optimal_stopping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "decision/stopping.hpp"
#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

constexpr int record = 1;

/// The secretary problem as a Markov chain: state 1 means best so far.
StoppingProblem secretary(int n, const Discount& discount) {
  return {n, 2, [=](int k, int s) { return s == record ? discount(k) * k / n : 0.0; },
          [](int k, int, int next) { return next == record ? 1.0 / (k + 1) : k / (k + 1.0); }};
}

int first_stop(const StoppingSolution& solution) {
  for (std::size_t k = 0; k < solution.stop.size(); ++k) {
    if (solution.stop[k][record]) return static_cast<int>(k) + 1;
  }
  return 0;
}

TEST(BackwardInduction, AgreesWithTheClosedFormOfTheSecretaryProblem) {
  for (const int n : {3, 8, 30, 60}) {
    for (const double beta : {0.95, 0.8}) {
      const Discount discount = geometric_discount(beta);
      const StoppingSolution sut = backward_induction(secretary(n, discount));
      const SecretaryRule want = discounted_secretary(n, discount);
      EXPECT_EQ(first_stop(sut), want.r_star);
      EXPECT_NEAR(sut.value[0][record], want.value, 1e-12);
    }
    const StoppingSolution linear = backward_induction(secretary(n, linear_discount(0.5, n)));
    EXPECT_EQ(first_stop(linear), discounted_secretary(n, linear_discount(0.5, n)).r_star);
  }
}

TEST(BackwardInduction, IsForcedToStopAtTheHorizon) {
  const StoppingSolution sut =
      backward_induction({1, 1, [](int, int) { return -5.0; }, [](int, int, int) { return 1.0; }});
  EXPECT_EQ(sut.value[0][0], -5);
  EXPECT_TRUE(sut.stop[0][0]);
}

TEST(BackwardInduction, StopsOnATie) {
  const StoppingSolution sut =
      backward_induction({2, 1, [](int, int) { return 3.0; }, [](int, int, int) { return 1.0; }});
  EXPECT_TRUE(sut.stop[0][0]);
}

TEST(BackwardInduction, RejectsEmptyProblems) {
  EXPECT_THROW((void)backward_induction({0, 1, {}, {}}), ConfigError);
  EXPECT_THROW((void)backward_induction({1, 0, {}, {}}), ConfigError);
}

// Gilbert & Mosteller 1966: 0.5802 in the limit; table of the checked theory for N = 5 to 100.
TEST(FullInformation, HasTheKnownValues) {
  EXPECT_NEAR(full_information(5, 1).value, 0.6392, 5e-5);
  EXPECT_NEAR(full_information(30, 0.95).value, 0.3053, 5e-5);
  EXPECT_NEAR(full_information(100, 1).value, 0.5829, 5e-5);
  EXPECT_NEAR(full_information(2, 1).threshold[0], 0.5, 1e-12);
}

TEST(FullInformation, AcceptsLessAndLess) {
  const FullInformationRule sut = full_information(30, 0.95);
  for (std::size_t k = 1; k < 30; ++k) EXPECT_LT(sut.threshold[k], sut.threshold[k - 1]);
  EXPECT_EQ(sut.threshold.back(), 0);
}

TEST(FullInformation, BeatsTheRuleThatSeesRanksOnly) {
  EXPECT_GT(full_information(30, 0.95).value,
            discounted_secretary(30, geometric_discount(0.95)).value);
}

TEST(Moser, HasTheKnownReservations) {
  const MoserRule sut = moser(5, 1, normal_law(thesis_bad));
  EXPECT_NEAR(sut.reservation[3], 36.599, 1e-12);
  EXPECT_NEAR(sut.reservation[0], 42.43370678929151, 1e-9);
  EXPECT_NEAR(sut.value, 43.336165375047266, 1e-9);
}

TEST(Moser, HasTheKnownUniformSequence) {
  const MoserRule sut = moser(3, 1, uniform_law());  // 1/2, 5/8, 89/128
  EXPECT_DOUBLE_EQ(sut.reservation[1], 0.5);
  EXPECT_DOUBLE_EQ(sut.reservation[0], 0.625);
  EXPECT_DOUBLE_EQ(sut.value, 89 / 128.);
}

TEST(Bearden, HasThresholdsNearTheSquareRoot) {
  const int n[] = {5, 10, 20, 30, 60, 100};
  const int r[] = {2, 3, 5, 6, 8, 10};
  const double v[] = {0.65, 0.7333, 0.80, 0.8333, 0.8792, 0.905};
  for (int i = 0; i < 6; ++i) {
    const BeardenRule sut = bearden(n[i], 1, uniform_law());
    EXPECT_EQ(sut.r_star, r[i]);
    EXPECT_NEAR(sut.value, v[i], 5e-5);
  }
}

TEST(Bearden, TakesTheFirstWhenWaitingCostsMuch) {
  EXPECT_EQ(bearden(30, 0.8, uniform_law()).r_star, 1);
  EXPECT_EQ(bearden(30, 0.95, normal_law(thesis_good)).r_star, 1);
  EXPECT_EQ(bearden(1, 0.9, uniform_law()).r_star, 1);
}

// The thesis prints r = 6 for "p <= 1/2"; that is p = 0.9.
TEST(Parking, HasTheKnownRules) {
  EXPECT_EQ(parking(0.5).r, 0);
  EXPECT_EQ(parking(0.51).r, 1);
  EXPECT_EQ(parking(0.9).r, 6);
  EXPECT_NEAR(parking(0.9).cost, 6.565938, 1e-12);
  EXPECT_NEAR(parking(0.95).cost, 13.506999164621181, 1e-11);
  EXPECT_EQ(parking(0).cost, 0);
}

TEST(OptimalStopping, RejectsWhatIsOutOfRange) {
  EXPECT_THROW((void)parking(1), ConfigError);
  EXPECT_THROW((void)parking(-0.1), ConfigError);
  EXPECT_THROW((void)full_information(0, 1), ConfigError);
  EXPECT_THROW((void)full_information(5, 1.1), ConfigError);
  EXPECT_THROW((void)moser(5, 0, uniform_law()), ConfigError);
  EXPECT_THROW((void)bearden(0, 1, uniform_law()), ConfigError);
}

nlohmann::json load(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(golden_file(name)));
}

ValueLaw law_named(const std::string& name) {
  if (name == "uniform01") return uniform_law();
  if (name == "normal_f0") return normal_law(thesis_good);
  if (name == "normal_f1") return normal_law(thesis_bad);
  return mixture_law(thesis_good, thesis_bad, 0.5);
}

TEST(FullInformation, AgreesWithTheGoldenTable) {
  if (golden_file("dsp_full_information.json").empty()) GTEST_SKIP() << "no golden numbers";
  const auto file = load("dsp_full_information.json");
  Deviations all;
  for (const auto& row : file["table"]) {
    const FullInformationRule sut = full_information(row["N"], row["beta"]);
    for (std::size_t k = 0; k < sut.threshold.size(); ++k) {
      all.absolute(sut.threshold[k], row["thresholds_u"][k], 1e-9);
    }
    all.absolute(sut.value, row["value_beta_tau"], 1e-9);
    all.absolute(sut.p_best, row["p_best"], 1e-9);
    all.relative(sut.expected_stop, row["E_tau"], 1e-9);
  }
  std::cout << "dsp_full_information: " << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 30 * 3 + 5 * 225);
  EXPECT_EQ(all.outside(), 0);
}

TEST(Moser, AgreesWithTheGoldenTable) {
  if (golden_file("dsp_cardinal_moser.json").empty()) GTEST_SKIP() << "no golden numbers";
  const auto file = load("dsp_cardinal_moser.json");
  Deviations all;
  for (const auto& row : file["table"]) {
    const MoserRule sut = moser(row["N"], row["beta"], law_named(row["dist"]));
    for (std::size_t k = 0; k < sut.reservation.size(); ++k) {
      all.relative(sut.reservation[k], row["reservation"][k], 1e-9);
    }
    all.relative(sut.value, row["value_discounted"], 1e-9);
  }
  std::cout << "dsp_cardinal_moser: " << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 15 * 225);
  EXPECT_EQ(all.outside(), 0);
}

TEST(Bearden, AgreesWithTheGoldenTable) {
  if (golden_file("dsp_cardinal_bearden.json").empty()) GTEST_SKIP() << "no golden numbers";
  const auto file = load("dsp_cardinal_bearden.json");
  Deviations all;
  for (const auto& row : file["table"]) {
    const BeardenRule sut = bearden(row["N"], row["beta"], law_named(row["dist"]));
    all.exact(sut.r_star, row["r_star"]);
    all.strictly_relative(sut.value, row["value"], 1e-5);
  }
  std::cout << "dsp_cardinal_bearden: " << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 240);
  EXPECT_EQ(all.outside(), 0);
}

TEST(Parking, AgreesWithTheGoldenTable) {
  if (golden_file("thesis_checks.json").empty()) GTEST_SKIP() << "no golden numbers";
  const auto file = load("thesis_checks.json");
  Deviations all;
  for (const auto& row : file["parking"]) {
    all.exact(parking(row["p"]).r, row["r"]);
    all.relative(parking(row["p"]).cost, row["cost_eq14"], 1e-12);
  }
  for (const auto& row : file["table3"]) {
    const SecretaryRule sut = discounted_secretary(row["n"], geometric_discount(1));
    all.exact(sut.r_star, row["r1"]);
    all.absolute(sut.p_best, row["P"], 1e-12);
  }
  std::cout << "thesis_checks: " << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 28);
  EXPECT_EQ(all.outside(), 0);
}

}  // namespace
}  // namespace tocsin::decision
