// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "decision/detectors.hpp"
#include "decision/llr.hpp"

namespace tocsin::decision {

/// The normal scores of a quality under a law, z = Phi^-1(F(x)), from a table of 1001 cells over
/// [0,100]; with them FOCuS, which is made for a normal law, watches any. Held within +-8.
class NormalScores {
 public:
  explicit NormalScores(const Density& law);
  /// NaN for NaN.
  [[nodiscard]] double operator()(double x) const;

 private:
  std::vector<double> scores_;
};

/// A detector of "turned bad" that takes qualities, whichever it is: its statistic is in nats and
/// rises with the evidence. Constant time for each sample, no allocation, no throw. Copies start
/// where the original is.
class Detector {
 public:
  /// Page's CUSUM of the log-likelihood ratio.
  static Detector cusum(const Llr& llr) { return Detector(WithRatio<Cusum>{llr, {}}); }
  /// Shiryaev-Roberts of the same ratio; its statistic is ln R.
  static Detector shiryaev_roberts(const Llr& llr) {
    return Detector(WithRatio<ShiryaevRoberts>{llr, {}});
  }
  /// FOCuS for a fall of unknown size from the good law.
  static Detector focus(const Density& good);

  /// Takes one quality and returns the statistic; NaN is no evidence.
  double add(double qni);
  void reset();

 private:
  template <class Statistic>
  struct WithRatio {
    Llr llr;
    Statistic statistic;
  };
  struct WithScores {
    std::shared_ptr<const NormalScores> scores;  ///< empty: the law is normal
    Focus focus;
  };
  using Any = std::variant<WithRatio<Cusum>, WithRatio<ShiryaevRoberts>, WithScores>;
  explicit Detector(Any any) : any_(std::move(any)) {}

  Any any_;
};

}  // namespace tocsin::decision
