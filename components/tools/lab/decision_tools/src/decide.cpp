// SPDX-License-Identifier: Apache-2.0
#include "decide.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

using decision::Evidence;
using decision::Policy;
using decision::State;

bool at_deadline(const QualityTrace& trace, std::size_t row) {
  return !trace.recorded.empty() && trace.recorded[row].at_deadline;
}

/// The truth of the rows that are samples, which a recorded end of a pause is not.
std::vector<bool> truth_of_samples(const QualityTrace& trace) {
  std::vector<bool> bad;
  for (std::size_t row = 0; row < trace.bad.size(); ++row) {
    if (!at_deadline(trace, row)) bad.push_back(trace.bad[row]);
  }
  return bad;
}

std::unique_ptr<Policy> policy_for(const QualityTrace& trace, const std::string& policy,
                                   const PolicySettings& settings) {
  const decision::PolicyParams& params = settings.params;
  if (policy == "oracle") {
    if (trace.bad.empty()) {
      throw ConfigError(trace.path + ": policy oracle needs the truth, a column state of 0 and 1");
    }
    return decision::make_oracle(slots_of(truth_of_samples(trace), params.costs()),
                                 params.cost_change, params.th_max_samples);
  }
  try {
    return decision::make_policy(params);
  } catch (const ConfigError& error) {
    throw ConfigError(source_names(settings) + ": " + error.what());
  }
}

bool forced(decision::Reason reason) {
  return reason == decision::Reason::forced_resume_samples ||
         reason == decision::Reason::forced_resume_time;
}

bool is_sample(const Step& step, const QualityTrace& trace) {
  return step.row && !at_deadline(trace, *step.row);
}

void add_costs(const DecidedTrace& decided, DecisionSummary& summary) {
  std::vector<bool> bad = truth_of_samples(decided.trace);
  if (bad.size() < 2) return;
  bad.erase(bad.begin());
  std::vector<bool> send;
  for (const Step& step : decided.steps) {
    const bool active = step.evidence.state == State::active;
    if (is_sample(step, decided.trace)) {
      send.push_back(active);
    } else if (active && !send.empty()) {
      send.back() = true;  // it spoke from the deadline on
    }
  }
  send.pop_back();
  const decision::PolicyParams& params = decided.settings.params;
  const auto slots = slots_of(bad, params.costs());
  summary.has_truth = true;
  summary.cost = cost_of(slots, params.cost_change, send);
  summary.oracle_cost = clairvoyant(slots, params.cost_change, params.th_max_samples).cost;
}

/// Feeds rows to a policy and keeps what it says.
class Decider {
 public:
  Decider(const QualityTrace& trace, DecidedTrace& decided) : trace_(trace), decided_(decided) {}

  void begin_with(std::unique_ptr<Policy> policy) {
    policy_ = std::move(policy);
    deadline_.reset();
  }
  void take(std::size_t row) {
    const Time now{seconds(trace_.time_s[row])};
    const bool recorded = !trace_.recorded.empty();
    if (at_deadline(trace_, row)) {
      if (deadline_ && now >= *deadline_) end_pause(row, now);
      return;
    }
    if (deadline_ && now > *deadline_ + (recorded ? wake_up : Duration{0})) {
      end_pause(std::nullopt, *deadline_);
    }
    if (recorded) policy_->foresee(trace_.recorded[row].outlook);
    keep(row, now, policy_->on_sample({now, trace_.qni[row]}, now));
  }

 private:
  /// A controller that is woken at a deadline decides so much later at most, unless a sample came
  /// meanwhile: then that decides.
  static constexpr Duration wake_up = std::chrono::milliseconds(20);

  /// At the row's time, if it tells when the controller woke, else at the deadline itself.
  void end_pause(std::optional<std::size_t> row, Time now) {
    const bool in_time = now <= *deadline_ + wake_up;
    keep(row, in_time ? now : *deadline_, policy_->on_deadline(in_time ? now : *deadline_));
  }
  void keep(std::optional<std::size_t> row, Time now, const Evidence& evidence) {
    deadline_ = evidence.deadline;
    decided_.steps.push_back({to_seconds(now), row, evidence});
  }

  const QualityTrace& trace_;
  DecidedTrace& decided_;
  std::unique_ptr<Policy> policy_;
  std::optional<Time> deadline_;
};

bool equal(const RecordedDecision& recorded, const Evidence& evidence) {
  return recorded.active == (evidence.state == State::active) &&
         recorded.reason == to_string(evidence.reason) && recorded.pause_samples == evidence.age;
}

}  // namespace

DecidedTrace decide_again(const QualityTrace& trace, const std::string& policy,
                          const PolicySettings& settings) {
  DecidedTrace decided{trace, "", {}, settings};
  Decider decider(trace, decided);
  for (std::size_t row = 0; row < trace.qni.size(); ++row) {
    const bool restarted = !trace.recorded.empty() && trace.recorded[row].restarted;
    if (row == 0 || (restarted && policy != "oracle")) {
      auto made = policy_for(trace, policy, settings);
      decided.policy = made->name();
      decider.begin_with(std::move(made));
    }
    decider.take(row);
  }
  return decided;
}

DecisionSummary summarize(const DecidedTrace& decided) {
  DecisionSummary summary;
  double active = 0;
  double sum_active = 0;
  double sum_passive = 0;
  bool was_passive = false;
  for (const Step& step : decided.steps) {
    const Evidence& one = step.evidence;
    const bool passive = one.state == State::passive;
    summary.pauses += passive && !was_passive;
    summary.forced += one.changed && forced(one.reason);
    summary.longest_pause = std::max(summary.longest_pause, one.age);
    was_passive = passive;
    if (!is_sample(step, decided.trace)) continue;
    ++summary.samples;
    summary.passive += passive;
    if (std::isnan(one.sample)) {
      ++summary.missing;
    } else {
      active += !passive;
      (passive ? sum_passive : sum_active) += one.sample;
    }
  }
  const double silent = static_cast<double>(summary.samples - summary.missing) - active;
  summary.mean_qni_active = active > 0 ? sum_active / active : std::nan("");
  summary.mean_qni_passive = silent > 0 ? sum_passive / silent : std::nan("");
  add_costs(decided, summary);
  return summary;
}

std::optional<Comparison> compare_with_recording(const DecidedTrace& decided) {
  const std::vector<RecordedDecision>& recorded = decided.trace.recorded;
  if (recorded.empty()) return std::nullopt;
  std::vector<const Evidence*> of_row(recorded.size(), nullptr);
  for (const Step& step : decided.steps) {
    if (step.row) of_row[*step.row] = &step.evidence;
  }
  Comparison comparison;
  bool was_active = true;
  for (std::size_t row = 0; row < recorded.size(); ++row) {
    ++comparison.recorded;
    comparison.recorded_pauses += was_active && !recorded[row].active;
    was_active = recorded[row].active;
    if (of_row[row] != nullptr && equal(recorded[row], *of_row[row])) {
      ++comparison.same;
    } else if (!comparison.first_other) {
      comparison.first_other = row;
    }
  }
  return comparison;
}

}  // namespace tocsin::tools
