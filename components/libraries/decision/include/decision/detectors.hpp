// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "decision/cusum.hpp"

namespace tocsin::decision {

/// Shiryaev-Roberts: R_n = (1 + R_{n-1}) exp(l_n), kept as ln R. Alarm when ln R >= threshold.
class ShiryaevRoberts {
 public:
  /// Takes one log-likelihood ratio and returns ln R. NaN is ignored.
  double add(double l);
  [[nodiscard]] bool alarm(double threshold) const { return log_r_ >= threshold; }
  /// -infinity before the first sample.
  [[nodiscard]] double statistic() const { return log_r_; }
  /// Samples since the most likely change: the CUSUM of the same ratios.
  [[nodiscard]] std::uint32_t run() const { return cusum_.run(); }
  void reset() { *this = ShiryaevRoberts{}; }

 private:
  double log_r_ = -std::numeric_limits<double>::infinity();
  Cusum cusum_;
};

/// FOCuS (Romano, Eckley, Fearnhead, Rigaill, JMLR 2023), for a fall of unknown size of the mean
/// of a normal law of known mean and spread: the largest likelihood ratio over all change times
/// and sizes, max over tau of (S_n - S_tau)^2 / (2 (n - tau)), S the sum of (mean - x)/sd.
///
/// Only the vertices of the convex hull of (n, S_n) can attain the maximum; there are O(log n) of
/// them for noise. A steady ramp makes every point a vertex: beyond 64 the older ones are thinned
/// out, and the statistic is then a lower bound, 3 % low at worst on such a ramp. No allocation;
/// about 1 KB.
class Focus {
 public:
  /// Throws ConfigError unless the spread is positive.
  explicit Focus(Normal good = thesis_good);
  /// Takes one value and returns the statistic. NaN is ignored.
  double add(double x);
  [[nodiscard]] bool alarm(double threshold) const { return statistic_ >= threshold; }
  [[nodiscard]] double statistic() const { return statistic_; }
  /// Samples since the most likely change; 0 while no change is likely.
  [[nodiscard]] std::uint32_t run() const { return run_; }
  void reset();

 private:
  struct Vertex {
    double n;
    double sum;
  };
  static constexpr std::size_t capacity = 64;
  void push(const Vertex& vertex);
  void maximize();

  Normal good_;
  std::array<Vertex, capacity> hull_;
  std::size_t size_ = 1;
  Vertex last_{0, 0};
  double statistic_ = 0;
  std::uint32_t run_ = 0;
};

}  // namespace tocsin::decision
