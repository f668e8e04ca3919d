// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_policies.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "decision/design/costs.hpp"
#include "decision/design/fit.hpp"
#include "decision/design/scenario.hpp"
#include "decision/policy.hpp"
#include "foundation/error.hpp"
#include "metrics/slot_cost.hpp"

namespace tocsin::experiment {
namespace {

using decision::PolicyParams;

/// One of the two numbers of a policy, and what is tried for it.
struct Knob {
  const char* key;
  void (*set)(PolicyParams& params, double value);
  std::vector<double> grid;
};

std::vector<double> steps(double from, double to, double step) {
  std::vector<double> values;
  for (double value = from; value <= to; value += step) values.push_back(value);
  return values;
}

/// Empty for a policy that has no more than its laws.
std::vector<Knob> knobs_of(const std::string& policy) {
  const std::vector<double> sums{0.5, 1, 1.5, 2, 3, 4, 5.5, 7, 10, 15};
  const Knob alpha{"alpha", [](PolicyParams& p, double v) { p.alpha = v; }, sums};
  if (policy == "threshold") {
    return {{"pause_below_qni", [](PolicyParams& p, double v) { p.pause_below_qni = v; },
             steps(40, 85, 2.5)},
            {"resume_at_qni", [](PolicyParams& p, double v) { p.resume_at_qni = v; },
             steps(40, 90, 2.5)}};
  }
  if (policy == "tocp") {
    return {alpha,
            {"fixed_pause_samples",
             [](PolicyParams& p, double v) { p.fixed_pause_samples = static_cast<int>(v); },
             {2, 3, 4, 5, 7, 10, 15, 20, 25, 30}}};
  }
  if (policy == "tocp_dsp") {
    return {alpha,
            {"discount_value",
             [](PolicyParams& p, double v) { p.discount_value = v; },
             {0.3, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.99, 1}}};
  }
  if (policy == "tocp_reverse") {
    return {alpha, {"reverse_alpha", [](PolicyParams& p, double v) { p.reverse_alpha = v; }, sums}};
  }
  return {};
}

std::string text(const char* key, double value) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%s=%.4g", key, value);
  return buffer;
}

/// Mean cost over the clairvoyant's of the same traces, per 1000 slots; NaN: not a policy.
double regret(const std::vector<Trace>& traces, const PolicyParams& params) {
  try {
    double cost = 0;
    double slots = 0;
    for (const Trace& trace : traces) {
      const auto policy = decision::make_policy(params);
      const auto costs = params.costs();
      const auto all = decision::slots_of(trace.bad, costs);
      cost += decision::cost_of(all, costs.change, decision::decide(*policy, trace.qni));
      cost -= decision::clairvoyant(all, costs.change, params.th_max_samples).cost;
      slots += static_cast<double>(all.size());
    }
    return 1000 * cost / slots;
  } catch (const ConfigError&) {
    return std::nan("");
  }
}

/// The best of what has been tried.
class Search {
 public:
  Search(const std::vector<Trace>& traces, std::string policy)
      : traces_(traces), best_{std::move(policy), {}, std::nan("")} {}
  void try_out(const PolicyParams& params, std::vector<std::string> settings) {
    const double value = regret(traces_, params);
    if (std::isnan(value) || value >= best_.regret) return;
    best_.settings = std::move(settings);
    best_.regret = value;
  }
  [[nodiscard]] const Tuned& best() const { return best_; }

 private:
  const std::vector<Trace>& traces_;
  Tuned best_;
};

Tuned tune(const std::vector<Trace>& traces, PolicyParams params, const std::string& policy) {
  params.policy = value_of<decision::PolicyKind>(policy).value();
  Search search(traces, policy);
  const auto knobs = knobs_of(policy);
  if (knobs.empty()) search.try_out(params, {});
  if (knobs.empty()) return search.best();
  for (const double first : knobs[0].grid) {
    for (const double second : knobs[1].grid) {
      knobs[0].set(params, first);
      knobs[1].set(params, second);
      search.try_out(params, {text(knobs[0].key, first), text(knobs[1].key, second)});
    }
  }
  return search.best();
}

/// Mean length of the stretches in which `bad` is `wanted`.
double mean_length(const std::vector<Trace>& traces, bool wanted) {
  double slots = 0;
  double stretches = 0;
  for (const Trace& trace : traces) {
    for (std::size_t i = 0; i < trace.bad.size(); ++i) {
      if (trace.bad[i] != wanted) continue;
      slots += 1;
      if (i == 0 || trace.bad[i - 1] != wanted) stretches += 1;
    }
  }
  return std::max(1.5, slots / std::max(1.0, stretches));
}

/// Normal law of the samples in good or bad slots: mean, standard deviation.
decision::Density::Parameters law(const std::vector<Trace>& traces, bool bad,
                                  const std::string& mission) {
  std::vector<double> samples;
  for (const Trace& trace : traces) {
    for (std::size_t i = 0; i < trace.qni.size(); ++i) {
      if (trace.bad[i] == bad && std::isfinite(trace.qni[i])) samples.push_back(trace.qni[i]);
    }
  }
  const std::string name = "mission " + mission + (bad ? ", poor link" : ", good link");
  const auto data = decision::prepare_fit(samples, name.c_str());
  return decision::fit(decision::Family::normal, data).density.parameters();
}

}  // namespace

Trace trace_of(const std::vector<Observation>& series) {
  Trace trace{{}, bad_slots(series)};
  for (const Observation& one : series) trace.qni.push_back(one.qni);
  return trace;
}

PolicyParams fit_laws(const std::vector<Trace>& traces, const std::string& mission) {
  PolicyParams params;
  const auto good = law(traces, false, mission);
  const auto bad = law(traces, true, mission);
  params.good_mean = good[0];
  params.good_sd = good[1];
  params.bad_mean = bad[0];
  params.bad_sd = bad[1];
  params.mean_good_samples = mean_length(traces, false);
  params.mean_bad_samples = mean_length(traces, true);
  return params;
}

MissionFit fit_policies(const std::vector<Trace>& traces, const std::string& mission) {
  const PolicyParams params = fit_laws(traces, mission);
  MissionFit result;
  result.laws = {text("good_mean", params.good_mean),
                 text("good_sd", params.good_sd),
                 text("bad_mean", params.bad_mean),
                 text("bad_sd", params.bad_sd),
                 text("mean_good_samples", params.mean_good_samples),
                 text("mean_bad_samples", params.mean_bad_samples)};
  for (const char* policy : decision::policy_names) {
    // It looks at a map, which a trace has not.
    if (policy == std::string_view("foresight")) continue;
    result.policies.push_back(tune(traces, params, policy));
  }
  return result;
}

Fitted::mapped_type settings_of(const MissionFit& fit) {
  Fitted::mapped_type settings{{every_policy, fit.laws}};
  for (const Tuned& one : fit.policies) {
    if (!one.settings.empty()) settings[one.policy] = one.settings;
  }
  return settings;
}

}  // namespace tocsin::experiment
