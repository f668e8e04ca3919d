// SPDX-License-Identifier: Apache-2.0
#include "decision/stopping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

// Table 3 of the thesis, exact: 1, 1/2, 1/2, 11/24, 13/30, 77/180, 29/70, 459/1120.
TEST(Secretary, HasTheProbabilitiesOfTable3) {
  const double p[] = {1, 0.5, 0.5, 11 / 24., 13 / 30., 77 / 180., 29 / 70., 459 / 1120.};
  const int r[] = {1, 1, 2, 2, 3, 3, 3, 4};
  for (int n = 1; n <= 8; ++n) {
    const SecretaryRule sut = discounted_secretary(n, geometric_discount(1));
    EXPECT_EQ(sut.r_star, r[n - 1]) << n;
    EXPECT_NEAR(sut.p_best, p[n - 1], 1e-12) << n;
  }
}

TEST(Secretary, LosesByAnyOtherThreshold) {
  const auto discount = geometric_discount(0.95);
  const SecretaryRule sut = discounted_secretary(30, discount);
  for (int r = 1; r <= 30; ++r) {
    EXPECT_LE(secretary_with_threshold(30, r, discount).value, sut.value) << r;
  }
}

struct Row {
  int n;
  double discount;
  int r_star;
};

// Section 2.1 of the project's checked decision theory, equal to exact dynamic programming.
TEST(Secretary, HasTheKnownGeometricThresholds) {
  for (const Row& row : {Row{5, 0.95, 2}, Row{10, 0.9, 3}, Row{20, 0.8, 3}, Row{30, 1, 12},
                         Row{30, 0.99, 11}, Row{30, 0.95, 7}, Row{30, 0.9, 5}, Row{30, 0.8, 3},
                         Row{60, 0.99, 19}, Row{60, 0.95, 9}, Row{100, 1, 38}}) {
    EXPECT_EQ(discounted_secretary(row.n, geometric_discount(row.discount)).r_star, row.r_star);
  }
}

TEST(Secretary, HasTheKnownLinearThresholds) {
  for (const Row& row : {Row{30, 0, 12}, Row{30, 0.25, 11}, Row{30, 0.5, 10}, Row{30, 0.75, 8},
                         Row{30, 1, 7}, Row{60, 0, 23}, Row{60, 0.5, 19}, Row{60, 1, 13}}) {
    const auto discount = linear_discount(row.discount, row.n);
    EXPECT_EQ(discounted_secretary(row.n, discount).r_star, row.r_star);
  }
}

TEST(Secretary, HasTheKnownValue) {
  EXPECT_NEAR(discounted_secretary(30, geometric_discount(0.95)).value, 0.1619, 5e-5);
  EXPECT_NEAR(discounted_secretary(30, geometric_discount(0.95)).p_best, 0.3357, 5e-5);
}

TEST(Secretary, ApproachesTheClassicalThirtySevenPercent) {
  const SecretaryRule sut = discounted_secretary(1000000, geometric_discount(1));
  EXPECT_NEAR(sut.r_star / 1e6, std::exp(-1), 2e-6);
  EXPECT_NEAR(sut.p_best, std::exp(-1), 2e-6);
}

TEST(Secretary, RejectsWhatIsOutOfRange) {
  EXPECT_THROW((void)geometric_discount(0), ConfigError);
  EXPECT_THROW((void)geometric_discount(1.01), ConfigError);
  EXPECT_THROW((void)geometric_discount(NAN), ConfigError);
  EXPECT_THROW((void)linear_discount(10, 60), ConfigError);
  EXPECT_THROW((void)linear_discount(-0.1, 60), ConfigError);
  EXPECT_THROW((void)linear_discount(0.5, 0), ConfigError);
  EXPECT_THROW((void)discounted_secretary(0, geometric_discount(1)), ConfigError);
}

nlohmann::json load(const std::string& name) {
  return nlohmann::json::parse(std::ifstream(golden_file(name)));
}

TEST(Secretary, AgreesWithTheGoldenGeometricTable) {
  if (golden_file("dsp_rank.json").empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Deviations r;
  Deviations values;
  const auto file = load("dsp_rank.json");
  for (const auto& row : file["table"]) {
    const SecretaryRule sut = discounted_secretary(row["N"], geometric_discount(row["beta"]));
    r.exact(sut.r_star, row["r_star"]);
    values.absolute(sut.value, row["value_beta_tau"], 1e-12);
    values.absolute(sut.p_best, row["p_best"], 1e-12);
    values.relative(sut.expected_stop, row["E_tau"], 1e-12);
  }
  std::cout << "dsp_rank r*: " << r.summary() << "; values: " << values.summary() << '\n';
  EXPECT_EQ(r.compared(), 30);
  EXPECT_EQ(r.outside() + values.outside(), 0);
}

TEST(Secretary, AgreesWithTheGoldenLinearTable) {
  if (golden_file("dsp_lds.json").empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Deviations all;
  const auto file = load("dsp_lds.json");
  for (const auto& row : file["lds"]) {
    const SecretaryRule sut =
        discounted_secretary(row["N"], linear_discount(row["gamma"], row["N"]));
    all.exact(sut.r_star, row["r_star"]);
    all.absolute(sut.value, row["value"], 1e-12);
  }
  std::cout << "dsp_lds: " << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 84);
  EXPECT_EQ(all.outside(), 0);
}

}  // namespace
}  // namespace tocsin::decision
