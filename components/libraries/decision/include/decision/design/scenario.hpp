// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "decision/cusum.hpp"
#include "decision/design/costs.hpp"
#include "decision/policy.hpp"

namespace tocsin::decision {

/// A network that alternates between good and bad at random; lengths are geometric.
struct Scenario {
  const char* name;
  double mean_good_samples;
  double mean_bad_samples;
  Normal good;
  Normal bad;
  double correlation;  ///< of neighbouring deviations from the mean, [0,1)
  int ramp_samples;    ///< samples that the mean takes from one state to the other; 1 is a jump
  double glitch_share = 0;  ///< of samples that are worth nothing: uniform in [0,60]
};

/// The five on which policies are compared: S1 thesis, S2 long bad spells, S3 short fades, S4 bad
/// hard to tell from good, S5 correlated with ramps.
[[nodiscard]] const std::vector<Scenario>& standard_scenarios();

/// S1 with 1 % and with 5 % of glitches, which the policies do not know of.
[[nodiscard]] const std::vector<Scenario>& glitch_scenarios();

/// QNI by slot, in [0,100], and the truth.
struct SimulatedTrace {
  std::vector<double> qni;
  std::vector<bool> bad;
};

/// The same trace for the same seed on every machine with the same standard library. Begins good.
[[nodiscard]] SimulatedTrace simulate(const Scenario& scenario, int slots, std::uint64_t seed);

/// What `policy` does on the trace at one sample per second: index n is the slot of sample n, and
/// sample n decides slot n + 1. The first slot is spoken in.
[[nodiscard]] std::vector<bool> decide(Policy& policy, const std::vector<double>& qni);

/// `params` with the scenario's laws and lengths, as a policy that had been fitted would have.
[[nodiscard]] PolicyParams fitted_to(const Scenario& scenario, PolicyParams params);

/// Mean of one number per seed with its standard error.
struct Estimate {
  double mean;
  double standard_error;
};
[[nodiscard]] Estimate estimate(const std::vector<double>& values);

/// Costs above the clairvoyant's, per 1000 slots, one per seed: regret[policy][seed]. The traces
/// are the same for all policies, so that differences are paired.
struct Campaign {
  int seeds = 20;
  int slots = 200000;
  SlotCosts costs;
  int th_max_samples = 30;
};
[[nodiscard]] std::vector<std::vector<double>> regrets(const Scenario& scenario,
                                                       const std::vector<PolicyParams>& policies,
                                                       const Campaign& campaign);

}  // namespace tocsin::decision
