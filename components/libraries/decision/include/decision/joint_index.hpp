// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace tocsin::decision {

/// The readings that the joint index weighs: loss, round-trip time, retries, busy time, signal.
inline constexpr std::size_t joint_readings = 5;

/// What the joint index knows of a link, its readings in the order above. Defaults: the radio model
/// at 22 dB, against 10 dB less and against a channel that others keep 80 % busy (`joint_delay` of
/// the decision bench prints them); `tocsin fit --joint` has those of a link of one's own.
struct JointIndexParams {
  std::vector<double> joint_center{0.00674, 0.824, 0.323, 0.477, 72.9};
  std::vector<double> joint_scale{0.0917, 0.125, 0.154, 0.02, 3.5};
  std::vector<double> joint_fall{1.04, 2.42, 0.69, 1.21, 2.63, 0, 5.36, 0.836, 33, 0};
  std::vector<double> joint_correlation{0.126, -0.0496, 0.0904, 0.0893, -0.0826,
                                        0.3,   0.292,   0.434,  0.177,  0.589};

  template <class Visitor>
  void visit(Visitor& v) {
    v("joint_center", joint_center, {-1000, 1000},
      "index joint: scores of a good link, of loss, round-trip time, retries, busy time and "
      "signal");
    v("joint_scale", joint_scale, {1e-6, 1000}, "index joint: standard deviations of these");
    v("joint_fall", joint_fall, {0, 1000},
      "index joint: how many of these standard deviations a bad link is worse, five numbers for "
      "each "
      "kind of bad link");
    v("joint_correlation", joint_correlation, {-0.999, 0.999},
      "index joint: of each reading with those after it, ten numbers");
  }
};

/// The readings as the index takes them; absent and NaN mean "not told".
struct JointIndexInput {
  std::optional<double> per_percent{};    ///< [0,100]
  std::optional<double> rtt_ms{};         ///< mean of the answered probes
  std::optional<double> retry_percent{};  ///< retried frames of those sent, [0,100]
  std::optional<double> busy_percent{};   ///< channel utilisation, [0,100]
  std::optional<double> signal_dbm{};
};

/// One number for all readings of a link together: the projection of their scores on which a good
/// and a bad link lie furthest apart, their dependence counted in (Fisher's discriminant, w = R^-1
/// fall, R the correlation of a good link). For scores that are jointly normal with the same
/// covariance in both states the log-likelihood ratio is linear in it, so that every detector of a
/// quality becomes a joint one: the CUSUM of this index is the CUSUM of the joint ratio. Links are
/// bad in several ways; with more than one kind the worst of their projections counts.
///
/// Scores that grow with badness: asin sqrt of loss, retries and busy time, ln (1 + rtt/ms), minus
/// signal, less their center, over their scale, held within +-6. A weight that came out negative (a
/// worse reading would make the quality better) is 0 and the others are computed anew. Every subset
/// of readings has weights of its own, so that what the hardware does not tell is left out rightly.
/// Constant time for each sample, no allocation, no throw after construction.
class JointIndex {
 public:
  /// Throws ConfigError unless the lists have their lengths, the correlations are those of a matrix
  /// that is positive definite, and each kind of bad link has a reading that falls.
  explicit JointIndex(const JointIndexParams& params);

  /// [0,100]: with one kind a good link is 80 +-10, a bad one 80 - 10 distance(); NaN without any
  /// reading that tells good from bad.
  [[nodiscard]] double evaluate(const JointIndexInput& input) const;
  /// How many standard deviations good and the nearest kind of bad lie apart, all readings told.
  [[nodiscard]] double distance() const;

 private:
  using Weights = std::array<double, joint_readings>;
  static constexpr std::size_t subsets = std::size_t{1} << joint_readings;
  /// Towards a kind of bad link, by the set of readings that are told.
  struct Direction {
    std::array<Weights, subsets> weights{};  ///< of unit variance
    std::array<double, subsets> distance{};
  };

  Weights center_{};
  Weights scale_{};
  std::vector<Direction> directions_;
};

/// The score of each reading before centre and scale; NaN where it is not told.
[[nodiscard]] std::array<double, joint_readings> joint_scores(const JointIndexInput& input);

}  // namespace tocsin::decision
