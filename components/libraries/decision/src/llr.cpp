// SPDX-License-Identifier: Apache-2.0
#include "decision/llr.hpp"

#include <sstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

constexpr int table_cells = 1000;

/// Mean of the law within [0,100]; throws when hardly any of it lies there.
double mean_on_scale(const Density& law, const char* which) {
  const double mass = law.cdf(100) - law.cdf(0);
  if (!(mass >= 0.01)) {
    std::ostringstream text;
    text << "model: the " << which << " law " << to_string(law.family()) << " has mass " << mass
         << " in [0, 100], must be at least 0.01";
    throw ConfigError(text.str());
  }
  double sum = 0;
  for (int i = 0; i < table_cells; ++i) {
    const double a = 100.0 * i / table_cells;
    const double b = 100.0 * (i + 1) / table_cells;
    sum += (a + b) / 2 * (law.cdf(b) - law.cdf(a));
  }
  return sum / mass;
}

void check(const Density& good, const Density& bad, double clip) {
  const double good_mean = mean_on_scale(good, "good");
  const double bad_mean = mean_on_scale(bad, "bad");
  std::ostringstream text;
  if (!(good_mean > bad_mean)) {
    text << "model: mean of the good law " << good_mean << " must be above that of the bad law, "
         << bad_mean;
  } else if (!(clip >= 0)) {
    text << "model: clip " << clip << " must be 0 (none) or positive";
  }
  if (!text.str().empty()) throw ConfigError(text.str());
}

}  // namespace

DensityLlr::DensityLlr(const Density& good, const Density& bad, double clip)
    : good_(good), bad_(bad), clip_(clip > 0 ? clip : infinity), low_(0), high_(100) {
  check(good, bad, clip);
  for (int i = 0; i <= table_cells; ++i) {
    const double x = 100.0 * i / table_cells;
    if (raw(x) > raw(low_)) low_ = x;
  }
  high_ = low_;
  for (int i = 0; i <= table_cells; ++i) {
    const double x = 100.0 * i / table_cells;
    if (x > low_ && raw(x) < raw(high_)) high_ = x;
  }
}

double DensityLlr::raw(double x) const {
  return std::max(bad_.log_density(x), floor) - std::max(good_.log_density(x), floor);
}

double DensityLlr::operator()(double x) const {
  if (std::isnan(x)) return x;
  return std::clamp(raw(std::clamp(x, low_, high_)), -clip_, clip_);
}

}  // namespace tocsin::decision
