// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "decision/cusum.hpp"
#include "decision/false_alarms.hpp"

namespace tocsin::decision {

/// Quality whose deviations fade: x = mean + sd z, z_n = correlation z_{n-1} + noise, held within
/// [0,100], where a real index stays for a while, too.
struct Ar1Link {
  Normal law;
  double correlation;  ///< of neighbours, [0,1)
};

/// A link with a better and a worse state, both of which occur while it counts as good (people who
/// pass, a door); a hidden Markov chain with independent normal qualities in each.
struct TwoStateLink {
  Normal high;
  Normal low;
  double high_to_low;  ///< per sample
  double low_to_high;  ///< per sample
};

/// What was recorded, cut into blocks and strung together anew.
struct BlockLink {
  std::vector<double> recording;
  int block;  ///< [samples]
};

using LinkModel = std::variant<Ar1Link, TwoStateLink, BlockLink>;

/// "ar1", "two_state", "blocks".
[[nodiscard]] const char* name_of(const LinkModel& model);
/// How many numbers describe it; 0 for blocks.
[[nodiscard]] int parameter_count(const LinkModel& model);
/// Qualities as the model has them; the same for the same seed. `model` is copied.
[[nodiscard]] std::unique_ptr<QualitySource> source_of(const LinkModel& model, std::uint64_t seed);

/// Maximum likelihood of each transition from a quality within (0,100); what is held at 0 or 100
/// counts as "there or beyond". NaN is a gap. Throws ConfigError when fewer than 50 transitions
/// are left.
[[nodiscard]] Ar1Link fit_ar1(const std::vector<double>& qualities);

/// Baum and Welch's algorithm, from `start` or from both halves of the sorted qualities. NaN is a
/// gap. Throws ConfigError as fit_ar1.
[[nodiscard]] TwoStateLink fit_two_state(const std::vector<double>& qualities);
[[nodiscard]] TwoStateLink fit_two_state(const std::vector<double>& qualities,
                                         const TwoStateLink& start);

/// How well a model foretells each quality from those before. Were it the truth, the forecast's
/// distribution function at what came would be uniform and independent.
struct Residuals {
  double log_likelihood;  ///< of all forecasts
  double bic;             ///< smaller is better
  double ks;              ///< distance from uniform
  double correlation;     ///< the largest of lags 1 to 5, by its absolute value
  bool sound;             ///< both are within what chance does, or too small to matter
};
[[nodiscard]] Residuals residuals_of(const Ar1Link& model, const std::vector<double>& qualities);
[[nodiscard]] Residuals residuals_of(const TwoStateLink& model,
                                     const std::vector<double>& qualities);

/// A model chosen for a recording.
struct LinkFit {
  LinkModel model;
  Ar1Link ar1;
  Residuals ar1_residuals;
  TwoStateLink two_state;
  Residuals two_state_residuals;
};

/// The model with the smaller BIC among those whose residuals are sound, else blocks of `block`
/// samples (0: as long as correlation lasts). Throws ConfigError as fit_ar1.
[[nodiscard]] LinkFit fit_link(const std::vector<double>& qualities, int block);

/// The kind of `like` fitted to other qualities, without a choice.
[[nodiscard]] LinkModel fit_like(const LinkModel& like, const std::vector<double>& qualities);

/// A block length that holds the correlation of `qualities`: ten times the time in which it fades
/// to 1/e, at least 10 samples, at most a tenth of them.
[[nodiscard]] int block_for(const std::vector<double>& qualities);

}  // namespace tocsin::decision
