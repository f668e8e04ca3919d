// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "decision/cusum.hpp"
#include "decision/density.hpp"

namespace tocsin::decision {

/// Log-likelihood ratio l(x) = ln f1(x)/f0(x) of any two laws, in nats; positive when x looks bad.
///
/// Log-densities are held above -50, so that a law that ends inside [0,100] cannot make one sample
/// decide for ever. Where l turns inside [0,100], x is held at the turning point (see NormalLlr).
class DensityLlr {
 public:
  static constexpr double floor = -50;

  /// `clip` bounds |l|; 0 means no bound. Throws ConfigError when a law has less than 1 % of its
  /// mass in [0,100] or the good law's mean there is not above the bad law's.
  DensityLlr(const Density& good, const Density& bad, double clip);

  /// NaN for NaN.
  [[nodiscard]] double operator()(double x) const;
  [[nodiscard]] const Density& good() const { return good_; }
  [[nodiscard]] const Density& bad() const { return bad_; }

 private:
  [[nodiscard]] double raw(double x) const;

  Density good_;
  Density bad_;
  double clip_;
  double low_;
  double high_;
};

/// Either of the two, so that a detector takes one type and the normal pair stays fast.
class Llr {
 public:
  Llr(const NormalLlr& normal) : normal_(normal) {}      // NOLINT: a kind of Llr
  Llr(const DensityLlr& general) : general_(general) {}  // NOLINT: a kind of Llr
  [[nodiscard]] double operator()(double x) const { return general_ ? (*general_)(x) : normal_(x); }

 private:
  NormalLlr normal_;
  std::optional<DensityLlr> general_;
};

}  // namespace tocsin::decision
