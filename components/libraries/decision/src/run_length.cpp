// SPDX-License-Identifier: Apache-2.0
#include "decision/run_length.hpp"

#include <cassert>
#include <cmath>
#include <sstream>

#include "foundation/error.hpp"
#include "special_functions.hpp"

namespace tocsin::decision {
namespace {

/// The CUSUM on a lattice of `size` states of width 2 alpha / (2 size - 1), Brook and Evans.
class Chain {
 public:
  Chain(const StepLaw& law, double alpha, int size)
      : size_(static_cast<std::size_t>(size)), move_(size_ * size_), alarm_(size_) {
    const double width = 2 * alpha / (2 * size - 1);
    std::vector<double> above(2 * size_);  // above[d] = P(step > (d - size + 1/2) width)
    for (std::size_t d = 0; d < 2 * size_; ++d) {
      above[d] = law.above((static_cast<double>(d) - size + 0.5) * width);
    }
    for (std::size_t i = 0; i < size_; ++i) {
      move(i, 0) = 1 - above[size_ - i];
      for (std::size_t j = 1; j < size_; ++j) {
        move(i, j) = above[size_ + j - i - 1] - above[size_ + j - i];
      }
      alarm_[i] = above[2 * size_ - i - 1];
    }
  }

  /// Mean steps from state 0 to the alarm: states are removed from the top, their time and their
  /// ways out shared among the rest.
  [[nodiscard]] double mean_time() {
    std::vector<double> time(size_, 1.0);
    for (std::size_t n = size_ - 1; n > 0; --n) {
      double leave = alarm_[n];
      for (std::size_t j = 0; j < n; ++j) leave += move(n, j);
      for (std::size_t i = 0; i < n; ++i) {
        const double share = move(i, n) / leave;
        if (share == 0) continue;
        time[i] += share * time[n];
        alarm_[i] += share * alarm_[n];
        for (std::size_t j = 0; j < n; ++j) move(i, j) += share * move(n, j);
      }
    }
    return time[0] / alarm_[0];
  }

 private:
  double& move(std::size_t from, std::size_t to) { return move_[from * size_ + to]; }

  std::size_t size_;
  std::vector<double> move_;
  std::vector<double> alarm_;
};

/// How many states a run length is computed with.
constexpr int coarse = 200;
constexpr int fine = 400;

[[noreturn]] void reject(double samples, const char* relation, double limit) {
  std::ostringstream text;
  text << "false alarm every " << samples << " samples: cannot be had with these laws, must be "
       << relation << ' ' << limit;
  throw ConfigError(text.str());
}

/// Root of a rising function by false position with the Illinois correction.
struct Bracket {
  double low;
  double at_low;
  double high;
  double at_high;

  /// Strictly inside: the middle where false position ends on a side (a run length may be
  /// infinite).
  [[nodiscard]] double guess() const {
    const double x = low - at_low * (high - low) / (at_high - at_low);
    return x > low && x < high ? x : (low + high) / 2;
  }
  void narrow(double middle, double at_middle) {
    if (at_middle < 0) {
      low = middle;
      at_low = at_middle;
      if (same_side < 0) at_high /= 2;
    } else {
      high = middle;
      at_high = at_middle;
      if (same_side > 0) at_low /= 2;
    }
    same_side = at_middle < 0 ? -1 : 1;
  }
  int same_side = 0;
};

}  // namespace

double mean_run_length(const StepLaw& law, double alpha, bool smooth) {
  assert(alpha > 0);
  const double b = Chain(law, alpha, fine).mean_time();
  if (!smooth) return b;
  const double a = Chain(law, alpha, coarse).mean_time();
  constexpr double ratio = (2.0 * fine - 1) / (2.0 * coarse - 1);
  return b + (b - a) / (ratio * ratio - 1);  // the error falls with the square of the width
}

double alpha_for_run_length(const StepLaw& law, double samples, bool smooth) {
  const double least = 1 / law.above(0);
  if (!(samples > least)) reject(samples, "above", least);
  const auto excess = [&](double alpha) {
    return std::log(mean_run_length(law, alpha, smooth) / samples);
  };
  Bracket bracket{0, std::log(least / samples), 1, excess(1), 0};
  while (bracket.at_high < 0) {
    bracket = {bracket.high, bracket.at_high, 2 * bracket.high, 0, 0};
    if (bracket.high > 1000) {
      reject(samples, "at most", mean_run_length(law, bracket.low, smooth));
    }
    bracket.at_high = excess(bracket.high);
  }
  while (bracket.high - bracket.low > 1e-6 * bracket.high) {
    const double middle = bracket.guess();
    const double at_middle = excess(middle);
    if (std::abs(at_middle) < 1e-9) return middle;
    bracket.narrow(middle, at_middle);
  }
  return smooth ? bracket.guess() : bracket.high;  // with atoms the run length jumps
}

}  // namespace tocsin::decision
