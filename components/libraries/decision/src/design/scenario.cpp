// SPDX-License-Identifier: Apache-2.0
#include "decision/design/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tocsin::decision {

const std::vector<Scenario>& standard_scenarios() {
  static const std::vector<Scenario> scenarios{
      {"S1", 120, 20, thesis_good, thesis_bad, 0, 1},
      {"S2", 120, 60, thesis_good, thesis_bad, 0, 1},
      {"S3", 60, 5, thesis_good, thesis_bad, 0, 1},
      {"S4", 120, 20, thesis_good, {65, 12}, 0, 1},
      {"S5", 120, 20, thesis_good, thesis_bad, 0.8, 10},
  };
  return scenarios;
}

const std::vector<Scenario>& glitch_scenarios() {
  static const std::vector<Scenario> scenarios{
      {"S1 + 1 % glitches", 120, 20, thesis_good, thesis_bad, 0, 1, 0.01},
      {"S1 + 5 % glitches", 120, 20, thesis_good, thesis_bad, 0, 1, 0.05},
  };
  return scenarios;
}

SimulatedTrace simulate(const Scenario& scenario, int slots, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  const double fresh = std::sqrt(1 - scenario.correlation * scenario.correlation);
  SimulatedTrace trace;
  bool bad = false;
  double z = normal(random);
  double share = 0;  // how far the mean is on its way to bad
  for (int n = 0; n < slots; ++n) {
    const double leave = 1 / (bad ? scenario.mean_bad_samples : scenario.mean_good_samples);
    if (n > 0 && uniform(random) < leave) bad = !bad;
    share = std::clamp(share + (bad ? 1.0 : -1.0) / scenario.ramp_samples, 0.0, 1.0);
    if (n > 0) z = scenario.correlation * z + fresh * normal(random);
    const double mean = scenario.good.mean + share * (scenario.bad.mean - scenario.good.mean);
    const double sd = scenario.good.sd + share * (scenario.bad.sd - scenario.good.sd);
    trace.qni.push_back(std::clamp(mean + sd * z, 0.0, 100.0));
    trace.bad.push_back(bad);
    if (scenario.glitch_share > 0 && uniform(random) < scenario.glitch_share) {
      trace.qni.back() = 60 * uniform(random);
    }
  }
  return trace;
}

std::vector<bool> decide(Policy& policy, const std::vector<double>& qni) {
  std::vector<bool> send{true};
  send.reserve(qni.size());
  Time now{};
  for (std::size_t n = 0; n + 1 < qni.size(); ++n) {
    now += std::chrono::seconds(1);
    send.push_back(policy.on_sample({now, qni[n]}, now).state == State::active);
  }
  return send;
}

PolicyParams fitted_to(const Scenario& scenario, PolicyParams params) {
  params.good_mean = scenario.good.mean;
  params.good_sd = scenario.good.sd;
  params.bad_mean = scenario.bad.mean;
  params.bad_sd = scenario.bad.sd;
  params.mean_good_samples = scenario.mean_good_samples;
  params.mean_bad_samples = scenario.mean_bad_samples;
  return params;
}

Estimate estimate(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  double mean = 0;
  for (const double x : values) mean += x / n;
  double square = 0;
  for (const double x : values) square += (x - mean) * (x - mean);
  return {mean, n > 1 ? std::sqrt(square / (n - 1) / n) : 0};
}

std::vector<std::vector<double>> regrets(const Scenario& scenario,
                                         const std::vector<PolicyParams>& policies,
                                         const Campaign& campaign) {
  std::vector<std::vector<double>> result(policies.size());
  for (int seed = 1; seed <= campaign.seeds; ++seed) {
    const SimulatedTrace trace =
        simulate(scenario, campaign.slots, static_cast<std::uint64_t>(seed));
    const std::vector<Slot> slots = slots_of(trace.bad, campaign.costs);
    const double change = campaign.costs.change;
    const double least = clairvoyant(slots, change, campaign.th_max_samples).cost;
    for (std::size_t i = 0; i < policies.size(); ++i) {
      const auto policy = make_policy(policies[i]);
      const double cost = cost_of(slots, change, decide(*policy, trace.qni));
      result[i].push_back((cost - least) * 1000 / campaign.slots);
    }
  }
  return result;
}

}  // namespace tocsin::decision
