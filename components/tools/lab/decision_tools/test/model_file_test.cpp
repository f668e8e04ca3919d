// SPDX-License-Identifier: Apache-2.0
#include "model_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decision/design/fit.hpp"
#include "decision/policy_model.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using decision::Density;
using decision::Family;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Density low(Family::normal, {20, 5, 0});

decision::PolicyParams read_back(const std::string& text) {
  const TemporaryFolder folder;
  return load_settings({{}, folder.write("m.yaml", text), {}, ""}).params;
}

template <class Function>
std::string error_of(Function function) {
  try {
    function();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ModelText, OfEveryFamilyReadsBackAsTheSameLaw) {
  const auto data = decision::prepare_fit(normal_trace(70, 9, 120).qni, "data");
  for (const decision::Fit& fit : decision::fit_all(data)) {
    const std::string family = to_string(fit.density.family());
    SCOPED_TRACE(family);
    const std::string text = model_text(fit.density, low, "a test");
    ASSERT_EQ(error_of([&] { check_model(text); }), "no error");
    const decision::PolicyParams read = read_back(text);
    EXPECT_EQ(read.good_family, family);
    const Density good = good_law_of(read);
    for (const double x : {5.0, 40.0, 70.0, 95.0}) {
      const double wanted = fit.density.log_density(x);
      EXPECT_NEAR(good.log_density(x), wanted, 1e-6 * std::max(1.0, std::abs(wanted))) << x;
    }
    EXPECT_EQ(bad_law_of(read).parameters(), low.parameters());
  }
}

TEST(ModelText, NamesTheParametersOfAFamilyForWhoReadsTheFile) {
  const std::string text = model_text(Density(Family::weibull, {80, 6, 0}), low, "a test");
  EXPECT_EQ(text,
            "# a test\n"
            "good_family: weibull\ngood_parameters: [80, 6]  # scale shape\n"
            "bad_mean: 20\nbad_sd: 5\n");
}

TEST(ModelText, AnOriginWithALineBreakStaysInItsComment) {
  const std::string text = model_text(Density(Family::normal, {80, 6, 0}), low, "a\nalpha: 99");
  EXPECT_THAT(text, StartsWith("# a\\nalpha: 99\n"));
  EXPECT_EQ(read_back(text).alpha, decision::PolicyParams{}.alpha);
}

TEST(CheckModel, RefusesWhatNoPolicyWouldTake) {
  const auto error = [](const Density& good, const Density& bad) {
    return error_of([&] { check_model(model_text(good, bad, "a test")); });
  };
  const Density high(Family::normal, {80, 6, 0});
  EXPECT_EQ(error(high, low), "no error");
  EXPECT_THAT(error(low, high), HasSubstr("mean of the good law 20 must be above"));
  EXPECT_EQ(error(Density(Family::normal, {80, 0.01, 0}), low), "no error");
  EXPECT_THAT(error(Density(Family::normal, {80, 0.005, 0}), low),
              HasSubstr("policy.good_sd: 0.005 is outside [0.01, 100]"));
  EXPECT_THAT(error(Density(Family::beta, {4e7, 1e7, 0}), low),
              HasSubstr("policy.good_parameters: 40000000"));
  EXPECT_THAT(error(Density(Family::weibull, {1e6, 50, 0}), low),
              HasSubstr("in [0, 100], must be at least 0.01"))
      << "a law without mass on the scale";
}

TEST(WriteText, ReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const std::string path = folder.write("m.yaml", "a longer text than the new one");
  write_text(path, "short");
  EXPECT_EQ(folder.read("m.yaml"), "short");
}

TEST(WriteText, SaysWhyAFileCannotBeWritten) {
  const TemporaryFolder folder;
  const auto error = [](const std::string& path) {
    return error_of([&] { write_text(path, "text"); });
  };
  EXPECT_EQ(error(folder.path("no/m.yaml")),
            folder.path("no/m.yaml") + ": cannot be written: No such file or directory");
  EXPECT_EQ(error(folder.path("")), folder.path("") + ": cannot be written: Is a directory");
  EXPECT_EQ(error("/dev/full"), "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace tocsin::tools
