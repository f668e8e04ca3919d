// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <sstream>

#include "decision/design/link_model.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "held_normal.hpp"
#include "minimize.hpp"

namespace tocsin::decision {
namespace {

struct Transition {
  double from;
  double to;
};

/// The transitions of a recording: the sums of those within (0,100), and each one that ends at 0 or
/// 100. What starts there is left out, which does not bias: a transition's likelihood is given its
/// start.
struct Transitions {
  explicit Transitions(const std::vector<double>& x) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      if (std::isnan(x[i - 1]) || std::isnan(x[i]) || is_held(x[i - 1])) continue;
      if (is_held(x[i])) {
        held.push_back({x[i - 1], x[i]});
      } else {
        add(x[i - 1] - centre, x[i] - centre);
      }
    }
  }
  void add(double a, double b) {
    n += 1;
    from += a;
    to += b;
    from_from += a * a;
    from_to += a * b;
    to_to += b * b;
  }
  static constexpr double centre = 80;  // keeps digits
  double n = 0;
  double from = 0;
  double to = 0;
  double from_from = 0;
  double from_to = 0;
  double to_to = 0;
  std::vector<Transition> held;
};

double cost(const Transitions& t, const Ar1Link& link) {
  const double phi = link.correlation;
  const double base = (link.law.mean - Transitions::centre) * (1 - phi);
  const double variance = link.law.sd * link.law.sd * (1 - phi * phi);
  const double squares = t.to_to + phi * phi * t.from_from + t.n * base * base -
                         2 * phi * t.from_to - 2 * base * t.to + 2 * base * phi * t.from;
  double sum = 0.5 * (squares / variance + t.n * std::log(2 * M_PI * variance));
  for (const Transition& one : t.held) {
    const double mean = link.law.mean + phi * (one.from - link.law.mean);
    sum -= HeldNormal{mean, variance}.log_density(one.to);
  }
  return sum;
}

/// Mean, ln sd and atanh of the correlation, as the search has them.
Ar1Link decode(const std::vector<double>& x) { return {{x[0], std::exp(x[1])}, std::tanh(x[2])}; }

bool inside(const std::vector<double>& x) {
  return std::abs(x[0]) < 1000 && std::abs(x[1]) < 7 && x[2] > -1 && x[2] < 5;
}

std::vector<double> start(const Transitions& t) {
  const double mean = t.from / t.n;
  const double variance = std::max(1e-4, t.from_from / t.n - mean * mean);
  const double covariance = t.from_to / t.n - mean * t.to / t.n;
  const double phi = std::max(-0.5, std::min(0.995, covariance / variance));
  return {mean + Transitions::centre, std::log(variance) / 2, std::atanh(phi)};
}

}  // namespace

Ar1Link fit_ar1(const std::vector<double>& qualities) {
  const Transitions transitions(qualities);
  if (transitions.n < 50) {
    std::ostringstream text;
    text << "recording: " << transitions.n
         << " pairs of neighbouring qualities between 0 and 100, at least 50 are needed";
    throw ConfigError(text.str());
  }
  const auto found = minimize(
      [&](const std::vector<double>& x) {
        return inside(x) ? cost(transitions, decode(x)) : infinity;
      },
      start(transitions));
  return decode(found.x);
}

}  // namespace tocsin::decision
