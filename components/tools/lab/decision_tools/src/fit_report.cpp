// SPDX-License-Identifier: Apache-2.0
#include "fit_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::tools {
namespace {

using decision::Density;
using decision::Fit;

constexpr std::size_t bins = 40;

std::string printed(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string printed(const char* format, ...) {
  char buffer[400];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

Density choose(const std::vector<Fit>& fits, const std::string& family) {
  if (family.empty()) return fits.front().density;
  for (const Fit& fit : fits) {
    if (family == to_string(fit.density.family())) return fit.density;
  }
  std::vector<std::string> known;
  for (const auto one : decision::all_families()) known.emplace_back(to_string(one));
  throw ConfigError("--family: '" + family + "' is not one of: " + joined(known, " ") +
                    suggestion(known, family));
}

/// Share of the data per unit of quality, in bins over [0,100].
nlohmann::json histogram(const FitReport& report) {
  constexpr double count = bins;
  constexpr double width = 100 / count;
  const double share = 1 / (width * static_cast<double>(report.data.sorted.size()));
  std::vector<double> x(bins);
  std::vector<double> y(bins, 0.0);
  for (std::size_t i = 0; i < bins; ++i) x[i] = (static_cast<double>(i) + 0.5) * width;
  for (const double value : report.data.sorted) {
    y[static_cast<std::size_t>(std::min(value / 100 * count, count - 1))] += share;
  }
  const std::string n = ", n = " + std::to_string(report.data.sorted.size());
  return {{"name", report.trace.path + n}, {"style", "bars"}, {"x", x}, {"y", y}};
}

nlohmann::json curve(const Density& law) {
  std::vector<double> all_x;
  std::vector<double> y;
  for (double x = 0.25; x < 100; x += 0.25) {
    const double f = std::exp(law.log_density(x));
    if (!std::isfinite(f)) continue;
    all_x.push_back(x);
    y.push_back(f);
  }
  return {{"name", describe(law)}, {"x", all_x}, {"y", y}};
}

nlohmann::json half(const FitReport& report, const char* title) {
  return {{"title", title},
          {"y", "density"},
          {"range", {0, nullptr}},
          {"lines", {histogram(report), curve(report.chosen)}}};
}

}  // namespace

FitReport fit_trace(const QualityTrace& trace, const std::string& family) {
  const std::vector<double> values = trace.measured();
  const decision::FitData data = decision::prepare_fit(values, trace.path.c_str());
  std::vector<Fit> fits = decision::fit_all(data);
  const Density chosen = choose(fits, family);
  return {trace, trace.qni.size() - values.size(), data, std::move(fits), chosen};
}

std::string describe(const Density& law) {
  const auto names = parameter_names(law.family());
  std::string text = std::string(to_string(law.family())) + "(";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += printed("%s%s=%.5g", i > 0 ? ", " : "", names[i], law.parameters()[i]);
  }
  return text + ")";
}

std::string to_text(const FitReport& report) {
  std::string text =
      printed("%s: %zu samples (%s), %zu without measurement, %zu held in [0.5, 99.5]\n",
              report.trace.path.c_str(), report.data.sorted.size(), report.trace.kind.c_str(),
              report.missing, report.data.held);
  text += printed("neighbours correlate by %.2f: as good as %.0f independent samples\n",
                  report.data.lag1, report.data.effective_size);
  text += printed("  %-18s %12s %10s %10s %10s %7s\n", "family", "log-lik.", "AIC", "AICc", "BIC",
                  "KS");
  for (const Fit& fit : report.fits) {
    text += printed("%c %-18s %12.3f %10.2f %10.2f %10.2f %7.4f  %s%s\n",
                    fit.density.family() == report.chosen.family() ? '*' : ' ',
                    to_string(fit.density.family()), fit.log_likelihood, fit.aic, fit.aicc, fit.bic,
                    fit.ks, describe(fit.density).c_str(), fit.at_boundary ? "  at boundary" : "");
  }
  return text;
}

nlohmann::json to_json(const FitReport& report) {
  nlohmann::json fits = nlohmann::json::array();
  for (const Fit& fit : report.fits) {
    nlohmann::json parameters;
    const auto names = parameter_names(fit.density.family());
    for (std::size_t i = 0; i < names.size(); ++i) {
      parameters[names[i]] = fit.density.parameters()[i];
    }
    fits.push_back({{"family", to_string(fit.density.family())},
                    {"parameters", parameters},
                    {"log_likelihood", fit.log_likelihood},
                    {"aic", fit.aic},
                    {"aicc", fit.aicc},
                    {"bic", fit.bic},
                    {"ks", fit.ks},
                    {"at_boundary", fit.at_boundary}});
  }
  return {{"file", report.trace.path},
          {"kind", report.trace.kind},
          {"samples", report.data.sorted.size()},
          {"missing", report.missing},
          {"held", report.data.held},
          {"lag1_correlation", report.data.lag1},
          {"effective_samples", report.data.effective_size},
          {"chosen", to_string(report.chosen.family())},
          {"fits", fits}};
}

nlohmann::json fit_plot(const FitReport& good, const FitReport& bad) {
  return {{"title", "Laws of the quality index"},
          {"x", "QNI"},
          {"range", {0, 100}},
          {"panels", {half(good, "good network"), half(bad, "bad network")}}};
}

}  // namespace tocsin::tools
