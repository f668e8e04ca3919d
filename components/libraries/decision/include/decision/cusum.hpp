// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tocsin::decision {

/// A normal law. `sd` is the standard deviation, above 0.
struct Normal {
  double mean;
  double sd;
};

/// QNI of a good and of a bad network as fitted in the thesis, section 5.3.2.
inline constexpr Normal thesis_good{81.5669, 10.3309};
inline constexpr Normal thesis_bad{36.5990, 7.3819};

/// Log-likelihood ratio l(x) = ln f1(x)/f0(x) of two normal laws, in nats: positive when x looks
/// bad. The thesis's equation (29), corrected:
/// l(x) = ln(s0/s1) + (x-m0)^2/(2 s0^2) - (x-m1)^2/(2 s1^2).
///
/// With unequal spreads l is a parabola. Should it turn inside [0,100], x is held at the turning
/// point, so that a quality below "bad" never counts as good nor one above "good" as bad.
class NormalLlr {
 public:
  /// `clip` bounds |l|; 0 means no bound. Throws ConfigError unless good.mean > bad.mean, both
  /// spreads are positive and `clip` is not negative.
  explicit NormalLlr(Normal good = thesis_good, Normal bad = thesis_bad, double clip = 0);

  /// NaN for NaN. Infinite qualities are held at the end of the monotone range or give +-inf.
  [[nodiscard]] double operator()(double x) const {
    const double held = x < low_ ? low_ : (x > high_ ? high_ : x);
    const double z0 = (held - good_.mean) / good_.sd;
    const double z1 = (held - bad_.mean) / bad_.sd;
    const double l = offset_ + 0.5 * (z0 * z0 - z1 * z1);
    return l > clip_ ? clip_ : (l < -clip_ ? -clip_ : l);
  }
  [[nodiscard]] const Normal& good() const { return good_; }
  [[nodiscard]] const Normal& bad() const { return bad_; }

 private:
  Normal good_;
  Normal bad_;
  double offset_;
  double clip_;
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
};

/// Page's one-sided CUSUM on log-likelihood ratios: W_n = max(0, W_{n-1} + l_n), started at 0;
/// equals max over change times of the summed ratios. 16 bytes, so that millions fit in memory.
class Cusum {
 public:
  /// Takes one ratio and returns W. NaN is ignored.
  double add(double l) {
    if (std::isnan(l)) return w_;
    const double sum = w_ + l;
    run_ = sum > 0 ? run_ + 1 : 0;
    w_ = sum > 0 ? sum : 0;
    return w_;
  }
  /// True when W has reached `alpha` (at least, not only above).
  [[nodiscard]] bool alarm(double alpha) const { return w_ >= alpha; }
  [[nodiscard]] double statistic() const { return w_; }
  /// Samples since the most likely change: the change is estimated to lie before the last
  /// `run()` samples. 0 while no change is likely.
  [[nodiscard]] std::uint32_t run() const { return run_; }
  void reset() { *this = Cusum{}; }

 private:
  double w_ = 0;
  std::uint32_t run_ = 0;
};

}  // namespace tocsin::decision
