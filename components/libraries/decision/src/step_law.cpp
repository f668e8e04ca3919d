// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "decision/run_length.hpp"
#include "foundation/numbers.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

double between(const Normal& law, double a, double b) {
  return b <= a ? 0 : normal_interval((a - law.mean) / law.sd, (b - law.mean) / law.sd);
}

/// l(x) = a x^2 + b x + c without hold and clip.
class Parabola {
 public:
  explicit Parabola(const NormalLlr& llr) {
    const double w0 = 1 / (2 * llr.good().sd * llr.good().sd);
    const double w1 = 1 / (2 * llr.bad().sd * llr.bad().sd);
    a_ = w0 - w1;
    b_ = 2 * (llr.bad().mean * w1 - llr.good().mean * w0);
    c_ = std::log(llr.good().sd / llr.bad().sd) + llr.good().mean * llr.good().mean * w0 -
         llr.bad().mean * llr.bad().mean * w1;
  }

  /// The x with l(x) > y form (first, second): the inside for a <= 0, the outside for a > 0.
  /// On the side on which l is held (or has no second root) the bound is infinite.
  [[nodiscard]] std::pair<double, double> roots(double y, bool held) const {
    const double c = c_ - y;
    if (a_ == 0) return {-infinity, -c / b_};
    const double discriminant = b_ * b_ - 4 * a_ * c;
    if (discriminant < 0) return {0, 0};
    const double q = -(b_ - std::sqrt(discriminant)) / 2;  // b < 0: no cancellation
    double first = std::min(q / a_, c / q);
    double second = std::max(q / a_, c / q);
    if (held && a_ < 0) first = -infinity;
    if (held && a_ > 0) second = infinity;
    return {first, second};
  }
  [[nodiscard]] bool opens_up() const { return a_ > 0; }
  [[nodiscard]] bool turns_on_scale() const {
    const double vertex = -b_ / (2 * a_);
    return a_ != 0 && vertex > 0 && vertex < 100;
  }

 private:
  double a_;
  double b_;
  double c_;
};

/// P(l > y) or P(l < y), each summed from its own tail.
double tail(const Parabola& l, const Normal& truth, double y, bool upper) {
  const auto [first, second] = l.roots(y, l.turns_on_scale());
  if (upper != l.opens_up()) return between(truth, first, second);
  return between(truth, -infinity, first) + between(truth, second, infinity);
}

StepLaw normal_step_law(const NormalLlr& llr, double clip, Normal truth, bool upper) {
  const double limit = clip > 0 ? clip : infinity;
  return {[l = Parabola(llr), limit, truth, upper](double y) {
    if (y >= limit) return 0.0;
    if (y < -limit) return 1.0;
    return tail(l, truth, upper ? y : -y, upper);
  }};
}

/// Ratios of a grid over [0,100] with their probabilities, largest first, summed up.
class GridLaw {
 public:
  GridLaw(const Llr& llr, const Density& truth, double sign) {
    constexpr int cells = 10000;
    std::vector<std::pair<double, double>> steps;
    const double mass = truth.cdf(100) - truth.cdf(0);
    for (int i = 0; i < cells; ++i) {
      const double a = 100.0 * i / cells;
      const double b = 100.0 * (i + 1) / cells;
      steps.emplace_back(sign * llr((a + b) / 2), (truth.cdf(b) - truth.cdf(a)) / mass);
    }
    std::sort(steps.rbegin(), steps.rend());
    double sum = 0;
    for (const auto& [step, probability] : steps) {
      steps_.push_back(step);
      above_.push_back(sum);
      sum += probability;
    }
  }
  [[nodiscard]] double above(double y) const {
    const auto it = std::lower_bound(steps_.begin(), steps_.end(), y, std::greater<>());
    return it == steps_.end() ? 1 : above_[static_cast<std::size_t>(it - steps_.begin())];
  }

 private:
  std::vector<double> steps_;
  std::vector<double> above_;
};

StepLaw grid_step_law(const Llr& llr, const Density& truth, double sign) {
  return {
      [grid = std::make_shared<GridLaw>(llr, truth, sign)](double y) { return grid->above(y); }};
}

}  // namespace

StepLaw step_law(const NormalLlr& llr, double clip, Normal truth) {
  return normal_step_law(llr, clip, truth, true);
}

StepLaw reverse_step_law(const NormalLlr& llr, double clip, Normal truth) {
  return normal_step_law(llr, clip, truth, false);
}

StepLaw step_law(const Llr& llr, const Density& truth) { return grid_step_law(llr, truth, 1); }

StepLaw reverse_step_law(const Llr& llr, const Density& truth) {
  return grid_step_law(llr, truth, -1);
}

}  // namespace tocsin::decision
