// SPDX-License-Identifier: Apache-2.0
#include "decision/design/fit.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fit_start.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "minimize.hpp"

namespace tocsin::decision {
namespace {

/// Location-like parameters are searched as they are, positive ones by their logarithm.
bool is_location(Family family, std::size_t i) {
  const std::string name = parameter_names(family)[i];
  if (name == "k") return true;
  return name == "mu" && family != Family::inverse_gaussian && family != Family::exponential;
}

/// The box of the search: beyond it a family has degenerated into another.
struct Limits {
  double low;
  double high;
};

Limits limits(Family family, std::size_t i) {
  const std::string name = parameter_names(family)[i];
  if (name == "k") return {-0.999, 5};
  if (name == "nu") return {std::log(0.1), std::log(1e6)};
  if (family == Family::truncated_normal && i == 0) return {-2000, 2100};
  if (is_location(family, i)) return {-1e4, 1e4};
  return {std::log(1e-4), std::log(1e7)};
}

Density::Parameters decode(Family family, const std::vector<double>& x) {
  Density::Parameters p{};
  for (std::size_t i = 0; i < x.size(); ++i) p[i] = is_location(family, i) ? x[i] : std::exp(x[i]);
  return p;
}

std::vector<double> encode(Family family, const Density::Parameters& p) {
  std::vector<double> x(parameter_names(family).size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = is_location(family, i) ? p[i] : std::log(p[i]);
  return x;
}

bool inside(Family family, const std::vector<double>& x, double margin) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Limits limit = limits(family, i);
    const double edge = margin * (limit.high - limit.low);
    if (!(x[i] >= limit.low + edge && x[i] <= limit.high - edge)) return false;
  }
  return true;
}

double log_likelihood(const Density& density, const std::vector<double>& data) {
  double sum = 0;
  for (const double x : data) sum += density.log_density(x);
  return sum;
}

struct Search {
  Density::Parameters parameters;
  bool at_boundary;
};

Search search(Family family, const FitData& data) {
  const auto cost = [&](const std::vector<double>& x) {
    if (!inside(family, x, 0)) return infinity;
    const double sum = log_likelihood(Density(family, decode(family, x)), data.sorted);
    return std::isnan(sum) ? infinity : -sum;
  };
  const Density::Parameters start = starting_point(family, Moments(data.sorted));
  const Minimum minimum = minimize(cost, encode(family, start));
  return {decode(family, minimum.x), !minimum.converged || !inside(family, minimum.x, 1e-3)};
}

double ks_distance(const Density& density, const std::vector<double>& sorted) {
  const double n = static_cast<double>(sorted.size());
  double worst = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double f = density.cdf(sorted[i]);
    const double below = static_cast<double>(i);
    worst = std::max({worst, f - below / n, (below + 1) / n - f});
  }
  return worst;
}

double lag1_autocorrelation(const std::vector<double>& values) {
  double mean = 0;
  for (const double x : values) mean += x / static_cast<double>(values.size());
  double top = 0;
  double bottom = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    bottom += (values[i] - mean) * (values[i] - mean);
    if (i > 0) top += (values[i] - mean) * (values[i - 1] - mean);
  }
  return top / bottom;
}

void check(const std::vector<double>& values, const char* name) {
  std::ostringstream text;
  text << name << ": ";
  if (values.size() < 10) {
    text << values.size() << " samples, at least 10 are needed for a fit";
    throw ConfigError(text.str());
  }
  for (const double x : values) {
    if (std::isfinite(x)) continue;
    text << "a sample is " << x << ", must be finite";
    throw ConfigError(text.str());
  }
}

}  // namespace

FitData prepare_fit(const std::vector<double>& values, const char* name) {
  check(values, name);
  FitData data;
  for (const double x : values) {
    data.sorted.push_back(std::clamp(x, 0.5, 99.5));
    data.held += x < 0.5 || x > 99.5;
  }
  const auto [low, high] = std::minmax_element(data.sorted.begin(), data.sorted.end());
  if (*low == *high) {
    std::ostringstream text;
    text << name << ": all " << values.size() << " samples equal " << *low
         << ", a fit needs samples that vary";
    throw ConfigError(text.str());
  }
  data.lag1 = lag1_autocorrelation(data.sorted);
  const double share = std::clamp((1 - data.lag1) / (1 + data.lag1), 0.0, 1.0);
  data.effective_size = share * static_cast<double>(values.size());
  std::sort(data.sorted.begin(), data.sorted.end());
  return data;
}

Fit fit(Family family, const FitData& data) {
  Search found{starting_point(family, Moments(data.sorted)), false};
  if (!has_closed_form(family)) found = search(family, data);
  const Density density(family, found.parameters);
  const double n = static_cast<double>(data.sorted.size());
  const int k = static_cast<int>(parameter_names(family).size());
  const double l = log_likelihood(density, data.sorted);
  const double aic = 2 * k - 2 * l;
  return {density,
          l,
          k,
          aic,
          aic + 2.0 * k * (k + 1) / (n - k - 1),
          k * std::log(n) - 2 * l,
          ks_distance(density, data.sorted),
          found.at_boundary};
}

std::vector<Fit> fit_all(const FitData& data) {
  std::vector<Fit> fits;
  for (const Family family : all_families()) fits.push_back(fit(family, data));
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
    return a.at_boundary != b.at_boundary ? b.at_boundary : a.bic < b.bic;
  });
  return fits;
}

}  // namespace tocsin::decision
