// SPDX-License-Identifier: Apache-2.0
#include "minimize.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>

namespace tocsin::decision {
namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

/// NLopt compares values only, and infinity less infinity is none.
double finite(const Point& x, Point& /*gradient*/, void* function) {
  constexpr double highest = std::numeric_limits<double>::max() / 4;
  return std::min((*static_cast<const Function*>(function))(x), highest);
}

Point first_steps(const Point& start) {
  Point steps;
  for (const double x : start) steps.push_back(x == 0 ? 0.1 : 0.05 * std::abs(x));
  return steps;
}

Minimum descend(Function f, Point x) {
  nlopt::opt simplex(nlopt::LN_NELDERMEAD, static_cast<unsigned>(x.size()));
  simplex.set_min_objective(finite, &f);
  simplex.set_initial_step(first_steps(x));
  simplex.set_xtol_rel(1e-9);
  simplex.set_xtol_abs(1e-9);
  simplex.set_ftol_rel(1e-12);
  simplex.set_maxeval(6000);
  double value = 0;
  const nlopt::result ended = simplex.optimize(x, value);
  return {std::move(x), value, ended != nlopt::MAXEVAL_REACHED};
}

}  // namespace

Minimum minimize(const Function& f, const Point& start) { return descend(f, descend(f, start).x); }

}  // namespace tocsin::decision
