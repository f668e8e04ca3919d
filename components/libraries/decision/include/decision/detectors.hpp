// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "decision/llr.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::decision {

/// The detectors of "turned bad" that tocp, tocp_dsp and tocp_reverse may have: one row each of the
/// table in detectors.cpp.
enum class DetectorKind { cusum, focus };
inline constexpr auto words_of(DetectorKind) { return std::array{"cusum", "focus"}; }
inline constexpr Choices detector_names{"cusum", "focus"};

struct PolicyParams;

/// A detector that takes qualities; its statistic is in nats and rises with the evidence. Constant
/// time for each sample, no allocation, no throw.
class Detector {
 public:
  virtual ~Detector() = default;
  /// Takes one quality and returns the statistic; NaN is no evidence.
  virtual double add(double qni) = 0;
  /// Nothing has been heard yet.
  virtual void reset() = 0;
};

/// Page's CUSUM of the log-likelihood ratio.
class CusumDetector final : public Detector {
 public:
  explicit CusumDetector(const Llr& llr) : llr_(llr) {}
  double add(double qni) override { return cusum_.add(llr_(qni)); }
  void reset() override { cusum_.reset(); }

 private:
  Llr llr_;
  Cusum cusum_;
};

/// FOCuS (Romano, Eckley, Fearnhead, Rigaill, JMLR 2023), for a fall of unknown size of the mean
/// of a normal law of known mean and spread: the largest likelihood ratio over all change times
/// and sizes, max over tau of (S_n - S_tau)^2 / (2 (n - tau)), S the sum of (mean - x)/sd.
///
/// Only the vertices of the convex hull of (n, S_n) can attain the maximum; there are O(log n) of
/// them for noise. A steady ramp makes every point a vertex: beyond 64 the older ones are thinned
/// out, and the statistic is then a lower bound, 3 % low at worst on such a ramp. About 1 KB.
class Focus final : public Detector {
 public:
  /// Throws ConfigError unless the spread is positive.
  explicit Focus(Normal good = thesis_good);
  double add(double x) override;
  void reset() override;
  [[nodiscard]] double statistic() const { return statistic_; }
  /// Samples since the most likely change; 0 while no change is likely.
  [[nodiscard]] std::uint32_t run() const { return run_; }

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

/// The detector that the parameters name, with nothing heard yet. Throws ConfigError when it cannot
/// watch their laws.
[[nodiscard]] std::unique_ptr<Detector> detector_of(const PolicyParams& params);

/// At which statistic it alarms: alpha_of for the CUSUM; for FOCuS detector_threshold, else the
/// threshold with the run length that is wanted or that alpha has for the CUSUM, on independent
/// samples of the good law. That is simulated up to 2,000 samples, which takes a tenth of a second;
/// beyond, the run length is sqrt(h) exp(h) up to a constant (Siegmund and Venkatraman 1995).
[[nodiscard]] double detector_threshold_of(const PolicyParams& params);

}  // namespace tocsin::decision
