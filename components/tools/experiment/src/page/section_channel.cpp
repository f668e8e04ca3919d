// SPDX-License-Identifier: Apache-2.0
// The radio that the policies met, and in which of them a policy helps.
#include <algorithm>
#include <cmath>
#include <set>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

double snr(const Observation& one) { return one.snr_db; }

void add_snr_figure(const Group& group, double poor_below_db, double step_s, Document& document) {
  Figure figure("snr_" + round_id(group), mission_name(group.mission) + ", channel " +
                                              group.channel + ": mean SNR on the way");
  figure.axes("time [s]", "mean SNR [dB]");
  figure.band(percentile_series(group, snr, 0.1), percentile_series(group, snr, 0.9), step_s);
  const auto mean = mean_series(group, snr);
  figure.line("mean over runs", mean, step_s);
  figure.line("poor below", std::vector<double>(mean.size(), poor_below_db), step_s);
  document.figure(
      std::move(figure),
      "Mean over fading at the vehicle's place; shaded: 10th to 90th percentile of "
      "the runs, whose shadowing differs. Truly poor in " +
          html::number(estimate(group.metric(Metric::poor_share))) + " % of the time, in " +
          html::number(estimate(group.metric(Metric::poor_intervals))) + " intervals a run.");
}

const Group* of_policy(const std::vector<const Group*>& round, const std::string& policy) {
  for (const Group* group : round) {
    if (group->policy == policy) return group;
  }
  return nullptr;
}

/// The rounds in which TOCP-DSP can be compared with no policy.
std::vector<std::vector<const Group*>> comparable(const Results& results) {
  std::vector<std::vector<const Group*>> all;
  for (const char* kind : {"thesis", "comparison"}) {
    for (const RunSet* set : sets_of(results, kind)) {
      for (const auto& round : rounds_of(results.groups, set->name)) {
        if (of_policy(round, "tocp_dsp") && of_policy(round, "none")) all.push_back(round);
      }
    }
  }
  return all;
}

std::string judged(const Group& ours, const Group& none, Metric metric) {
  const Estimate difference = paired_difference(ours.metric(metric), none.metric(metric));
  const Verdict verdict = judge(difference, text_of(metric).less_is_better);
  const char* kind = verdict == Verdict::better ? "yes" : verdict == Verdict::worse ? "no" : "open";
  return std::string("<span class=\"") + kind + "\">" + html::number(difference) + "</span>";
}

/// One sentence from what the table shows.
std::string regime(const Group& ours, const Group& none) {
  int better = 0;
  int worse = 0;
  for (const Metric metric :
       {Metric::telemetry_per_max, Metric::high_lost, Metric::high_latency_p99}) {
    const Verdict verdict =
        judge(paired_difference(ours.metric(metric), none.metric(metric)), true);
    better += verdict == Verdict::better ? 1 : 0;
    worse += verdict == Verdict::worse ? 1 : 0;
  }
  if (better > 0 && worse == 0) return "helps";
  if (better == 0 && worse > 0) return "harms";
  return better == 0 ? "no difference shown" : "helps and harms";
}

}  // namespace

void add_channels(const Results& results, Document& document) {
  document.heading(2, "The channels");
  std::set<std::string> shown;
  for (const Group& group : results.groups) {
    const std::string key = group.mission + "." + group.channel;
    if (!shown.insert(key).second) continue;
    add_snr_figure(group, results.experiment.timing.poor_below_snr_db,
                   results.experiment.timing.observation_s, document);
    document.paragraph(
        mission_name(group.mission) + ", channel " + group.channel + ", payload " + group.payload +
        ", " + display_name(group.policy) + ": highest PER over probes " +
        html::number(estimate(group.metric(Metric::probe_per_max))) +
        " %, highest PER of telemetry " +
        html::number(estimate(group.metric(Metric::telemetry_per_max))) + " %, our own airtime " +
        html::number(estimate(group.metric(Metric::airtime))) +
        " %. Shadowing, background load and all else: see the channel files under "
        "Settings.");
  }
}

void add_regimes(const Results& results, Document& document) {
  const auto rounds = comparable(results);
  if (rounds.empty()) return;
  document.heading(2, "Where a policy helps, and where it does not");
  document.paragraph(
      "TOCP-DSP minus no policy, paired. Pausing a few kbit/s of telemetry does not make a link "
      "lose less: without the camera nothing is relieved, and what is paused is simply late. With "
      "the camera on a channel that is busy already, the queue before a poor link is full of "
      "pictures, and their silence gives the other classes room: they come sooner. Where the "
      "signal is weak but the channel not full, silence can even raise the loss of what is still "
      "sent; probably because the rate control then has only a few small packets to learn from.");
  document.paragraph(
      "Latency and age alone favour whoever says least: a policy that is silent half of the time "
      "has the emptiest queue. Read them together with the share of class low that was delivered.");
  std::vector<std::vector<std::string>> rows{
      {"set and round", "TOCP-DSP", "max PER of telemetry [%]", "lost, class high [%]",
       "p99 latency, high [ms]", "delivered, class low [%]", "location age p95 [s]"}};
  for (const auto& round : rounds) {
    const Group& ours = *of_policy(round, "tocp_dsp");
    const Group& none = *of_policy(round, "none");
    rows.push_back(
        {ours.set + ": " + round_title(ours), regime(ours, none),
         judged(ours, none, Metric::telemetry_per_max), judged(ours, none, Metric::high_lost),
         judged(ours, none, Metric::high_latency_p99), judged(ours, none, Metric::low_delivered),
         judged(ours, none, Metric::location_age_p95)});
  }
  document.table(rows);
}

}  // namespace tocsin::experiment
