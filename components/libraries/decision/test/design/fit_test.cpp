// SPDX-License-Identifier: Apache-2.0
#include "decision/design/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

std::vector<double> normal_data(double mean, double sd, int n) {
  std::mt19937_64 random(7);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> law(mean, sd);
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(law(random));
  return values;
}

std::string error_of(const std::vector<double>& values) {
  try {
    (void)prepare_fit(values, "good.csv");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Fit, FindsTheNormalLawByItsClosedForm) {
  const FitData data = prepare_fit({10, 20, 30, 40, 50, 60, 70, 80, 90, 50}, "x");
  const Fit sut = fit(Family::normal, data);
  EXPECT_DOUBLE_EQ(sut.density.parameters()[0], 50);
  EXPECT_NEAR(sut.density.parameters()[1], std::sqrt(600), 1e-12);
  EXPECT_NEAR(sut.aic, 4 - 2 * sut.log_likelihood, 1e-12);
  EXPECT_NEAR(sut.aicc, sut.aic + 12.0 / 7, 1e-12);
  EXPECT_NEAR(sut.bic, 2 * std::log(10) - 2 * sut.log_likelihood, 1e-12);
}

TEST(Fit, BeatsEveryNeighbour) {
  const FitData data = prepare_fit(normal_data(60, 12, 500), "x");
  for (const Family family : all_families()) {
    const Fit sut = fit(family, data);
    if (sut.at_boundary) continue;
    for (std::size_t i = 0; i < parameter_names(family).size(); ++i) {
      for (const double factor : {0.999, 1.001}) {
        Density::Parameters p = sut.density.parameters();
        p[i] *= factor;
        const Density neighbour(family, p);
        double sum = 0;
        for (const double x : data.sorted) sum += neighbour.log_density(x);
        EXPECT_LE(sum, sut.log_likelihood + 1e-9) << to_string(family) << ' ' << i;
      }
    }
  }
}

TEST(Fit, RanksTheRightFamilyFirst) {
  std::mt19937_64 random(3);  // NOLINT
  std::gamma_distribution<double> a(6, 1);
  std::gamma_distribution<double> b(1.6, 1);
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) {
    const double x = a(random);
    values.push_back(100 * x / (x + b(random)));
  }
  EXPECT_EQ(fit_all(prepare_fit(values, "x")).front().density.family(), Family::beta);
}

TEST(Fit, FlagsATLawThatRanToTheNormal) {
  const FitData data = prepare_fit({41, 43, 44, 45, 46, 47, 48, 49, 51, 53, 55, 57}, "x");
  EXPECT_TRUE(fit(Family::t_location_scale, data).at_boundary);
  EXPECT_FALSE(fit(Family::normal, data).at_boundary);
}

TEST(Fit, PutsFitsAtABoundaryLast) {
  const auto fits = fit_all(prepare_fit({41, 43, 44, 45, 46, 47, 48, 49, 51, 53, 55, 57}, "x"));
  EXPECT_EQ(fits.size(), 19U);
  EXPECT_TRUE(fits.back().at_boundary);
  EXPECT_FALSE(fits.front().at_boundary);
  EXPECT_LE(fits[0].bic, fits[1].bic);
}

TEST(Fit, HoldsDataAtTheEndsOfTheScale) {
  std::vector<double> values = normal_data(60, 10, 50);
  values.insert(values.end(), {0, 100, 100});
  const FitData sut = prepare_fit(values, "x");
  EXPECT_EQ(sut.held, 3U);
  EXPECT_EQ(sut.sorted.front(), 0.5);
  EXPECT_EQ(sut.sorted.back(), 99.5);
  for (const Fit& one : fit_all(sut)) EXPECT_TRUE(std::isfinite(one.log_likelihood));
}

TEST(Fit, TellsHowMuchNeighboursAgree) {
  std::vector<double> slow;
  for (int i = 0; i < 200; ++i) slow.push_back(50 + 30 * std::sin(i / 20.0));
  const FitData sut = prepare_fit(slow, "x");
  EXPECT_GT(sut.lag1, 0.95);
  EXPECT_LT(sut.effective_size, 10);
  EXPECT_GT(prepare_fit(normal_data(60, 10, 1000), "x").effective_size, 800);
}

TEST(Fit, RejectsDataThatCannotBeFitted) {
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of({}), HasSubstr("good.csv: 0 samples, at least 10"));
  EXPECT_THAT(error_of({50}), HasSubstr("1 samples, at least 10"));
  EXPECT_THAT(error_of(std::vector<double>(9, 1.5)), HasSubstr("9 samples"));
  EXPECT_THAT(error_of(std::vector<double>(20, 50)), HasSubstr("all 20 samples equal 50"));
  std::vector<double> holed = normal_data(50, 5, 20);
  holed[7] = NAN;
  EXPECT_THAT(error_of(holed), HasSubstr("must be finite"));
}

std::string golden_name(Family family) {
  if (family == Family::beta) return "beta_0_100";
  if (family == Family::truncated_normal) return "truncnormal_0_100";
  return to_string(family);
}

void compare(const nlohmann::json& row, const FitData& data, Deviations& numbers) {
  for (const Family family : all_families()) {
    if (golden_name(family) != row["family"]) continue;
    const Fit sut = fit(family, data);
    numbers.absolute(sut.log_likelihood, row["loglik"], 1e-6);
    numbers.absolute(sut.bic, row["bic"], 2e-6);
    numbers.absolute(sut.aicc, row["aicc"], 2e-6);
    numbers.absolute(sut.ks, row["ks"], 1e-4);
    const auto names = parameter_names(family);
    for (std::size_t i = 0; i < names.size(); ++i) {
      numbers.strictly_relative(sut.density.parameters()[i], row["params"][names[i]], 1e-4);
    }
    EXPECT_FALSE(sut.at_boundary) << row["family"];
  }
}

void compare_with_golden(const std::string& set, int numbers_expected) {
  const auto path = golden_file("fit_" + set + ".csv");
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table table = read_table(path);
  const FitData data = prepare_fit(table.columns["qni"], "golden");
  const auto file = nlohmann::json::parse(std::ifstream(golden_file("fit_reference.json")));
  Deviations numbers;
  int at_boundary = 0;
  for (const auto& row : file["sets"][set]["fits"]) {
    if (row["at_boundary"]) {
      ++at_boundary;
      EXPECT_TRUE(fit(*family_from(row["family"]), data).at_boundary);
    } else {
      compare(row, data, numbers);
    }
  }
  std::cout << set << ": " << numbers.summary() << "; " << at_boundary << " at a boundary\n";
  EXPECT_EQ(numbers.outside(), 0);
  EXPECT_EQ(numbers.compared(), numbers_expected);
}

TEST(Fit, AgreesWithGoldenSetA) { compare_with_golden("A_good_truncnormal", 107); }
TEST(Fit, AgreesWithGoldenSetB) { compare_with_golden("B_bad_truncnormal", 107); }

}  // namespace
}  // namespace tocsin::decision
