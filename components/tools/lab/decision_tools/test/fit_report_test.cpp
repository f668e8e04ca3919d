// SPDX-License-Identifier: Apache-2.0
// What tocsin fit tells of its laws: known formulas, the same in JSON, text and picture.
#include "fit_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "foundation/error.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(FitReportJson, OfANormalLawIsItsClosedForm) {
  QualityTrace trace = normal_trace(60, 8, 200);
  double mean = 0;
  double variance = 0;
  for (const double x : trace.qni) mean += x / 200;
  for (const double x : trace.qni) variance += (x - mean) * (x - mean) / 200;
  const auto json = to_json(fit_trace(trace, "normal"));
  for (const auto& fit : json["fits"]) {
    if (fit["family"] != "normal") continue;
    EXPECT_NEAR(fit["parameters"]["mu"].get<double>(), mean, 1e-9);
    EXPECT_NEAR(fit["parameters"]["sigma"].get<double>(), std::sqrt(variance), 1e-9);
    const double likelihood = -100 * (std::log(2 * M_PI * variance) + 1);
    EXPECT_NEAR(fit["log_likelihood"].get<double>(), likelihood, 1e-8);
    EXPECT_NEAR(fit["aicc"].get<double>(), 4 - 2 * likelihood + 2.0 * 2 * 3 / 197, 1e-8);
    return;
  }
  FAIL() << "no normal law";
}

TEST(FitReportJson, EveryFamilyIsRankedByItsInformationCriteria) {
  const auto json = to_json(fit_trace(normal_trace(75, 9, 150), ""));
  std::set<std::string> families;
  double bic = -1e9;
  bool at_boundary = false;
  for (const auto& fit : json["fits"]) {
    SCOPED_TRACE(fit["family"].get<std::string>());
    const double k = static_cast<double>(fit["parameters"].size());
    const double likelihood = fit["log_likelihood"].get<double>();
    EXPECT_NEAR(fit["aic"].get<double>(), 2 * k - 2 * likelihood, 1e-8);
    EXPECT_NEAR(fit["bic"].get<double>(), k * std::log(150) - 2 * likelihood, 1e-8);
    EXPECT_GE(fit["ks"].get<double>(), 0.5 / 150) << "no law passes nearer to a step function";
    EXPECT_LE(fit["ks"].get<double>(), 1);
    if (fit["at_boundary"].get<bool>() && !at_boundary) bic = -1e9;  // these come last
    EXPECT_GE(fit["at_boundary"].get<bool>(), at_boundary);
    EXPECT_GE(fit["bic"].get<double>(), bic);
    bic = fit["bic"].get<double>();
    at_boundary = fit["at_boundary"].get<bool>();
    families.insert(fit["family"].get<std::string>());
  }
  EXPECT_EQ(families.size(), 19U);
  EXPECT_EQ(json["chosen"], json["fits"][0]["family"]);
}

TEST(FitReportJson, CountsWhatWasNotMeasuredAndWhatWasHeld) {
  QualityTrace trace = normal_trace(60, 8, 100);
  trace.qni[3] = trace.qni[50] = nan;
  trace.qni[7] = 0;
  trace.qni[8] = 100;
  trace.qni[9] = 99.5;
  const FitReport sut = fit_trace(trace, "normal");
  EXPECT_EQ(to_json(sut)["samples"], 98);
  EXPECT_EQ(to_json(sut)["missing"], 2);
  EXPECT_EQ(to_json(sut)["held"], 2) << "99.5 is not beyond the limit";
  EXPECT_THAT(to_text(sut), HasSubstr("98 samples (test), 2 without measurement, 2 held in"));
}

TEST(FitReportText, MarksTheChosenLawOnce) {
  for (const char* family : {"", "gev", "rayleigh"}) {
    const FitReport sut = fit_trace(normal_trace(60, 8, 100), family);
    std::istringstream lines(to_text(sut));
    std::vector<std::string> marked;
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("* ", 0) == 0) marked.push_back(line);
    }
    ASSERT_EQ(marked.size(), 1U) << family;
    EXPECT_THAT(marked[0], HasSubstr(describe(sut.chosen)));
    if (*family != '\0') {
      EXPECT_EQ(to_string(sut.chosen.family()), std::string(family));
    }
  }
}

TEST(FitReportText, DescribesALawByTheNamesOfItsParameters) {
  using decision::Density;
  using decision::Family;
  EXPECT_EQ(describe(Density(Family::beta, {10.9, 2.66, 0})), "beta(a=10.9, b=2.66)");
  EXPECT_EQ(describe(Density(Family::gev, {-0.25, 8, 70})), "gev(k=-0.25, sigma=8, mu=70)");
  EXPECT_EQ(describe(Density(Family::exponential, {1.0 / 3, 9, 9})), "exponential(mu=0.33333)");
}

TEST(FitTrace, NamesAnUnknownFamilyAsItMayBeShown) {
  try {
    (void)fit_trace(normal_trace(60, 8, 50), "\x1b[2Jcauchy");
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("--family: '\\x1b[2Jcauchy' is not one of: normal logistic"));
    EXPECT_THAT(error.what(), HasSubstr("truncated_normal"));
  }
}

TEST(FitPlot, HistogramAndDensityHaveTheAreaOne) {
  const FitReport good = fit_trace(normal_trace(70, 6, 400), "normal");
  const FitReport bad = fit_trace(normal_trace(30, 6, 400), "normal");
  const auto sut = fit_plot(good, bad);
  for (const auto& panel : sut["panels"]) {
    double area = 0;
    for (const double y : panel["lines"][0]["y"]) area += y * 2.5;
    EXPECT_EQ(panel["lines"][0]["x"].size(), 40U);
    EXPECT_NEAR(area, 1, 1e-4);
    double mass = 0;
    for (const double y : panel["lines"][1]["y"]) mass += y * 0.25;
    EXPECT_NEAR(mass, 1, 1e-3);
  }
  const auto at_70 = [&](int panel) { return sut["panels"][panel]["lines"][1]["y"][279]; };
  EXPECT_GT(at_70(0).get<double>(), 10 * at_70(1).get<double>()) << "each with its own law";
}

TEST(FitPlot, TheBestAndTheWorstQualityAreInTheLastAndFirstBar) {
  QualityTrace trace = normal_trace(50, 3, 50);
  trace.qni[0] = 0;
  trace.qni[1] = trace.qni[2] = 100;
  const FitReport sut = fit_trace(trace, "normal");
  const auto bars = fit_plot(sut, sut)["panels"][0]["lines"][0]["y"];
  EXPECT_NEAR(bars.front().get<double>() * 2.5 * 50, 1, 1e-4);
  EXPECT_NEAR(bars.back().get<double>() * 2.5 * 50, 2, 1e-4);
}

}  // namespace
}  // namespace tocsin::tools
