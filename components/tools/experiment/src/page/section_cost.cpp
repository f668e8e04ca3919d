// SPDX-License-Identifier: Apache-2.0
// One cost for speaking and silence alike, and which policy is best at what.
#include <algorithm>
#include <cmath>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<std::string> contested{"telemetry_per_max", "high_latency_p99", "probe_per_max",
                                         "slot_cost", "low_delivered"};

const Group* ours_of(const std::vector<const Group*>& round) {
  const auto found = std::find_if(round.begin(), round.end(),
                                  [](const Group* group) { return group->policy == "tocp_dsp"; });
  return found == round.end() ? nullptr : *found;
}

/// The rounds in which several policies with TOCP-DSP among them were driven.
std::vector<std::vector<const Group*>> contests(const Results& results) {
  std::vector<std::vector<const Group*>> all;
  for (const char* kind : {"thesis", "comparison"}) {
    for (const RunSet* set : sets_of(results, kind)) {
      for (auto& round : rounds_of(results.groups, set->name)) {
        if (ours_of(round) != nullptr && round.size() > 1) all.push_back(std::move(round));
      }
    }
  }
  return all;
}

std::string coloured(const Estimate& difference, bool less_is_better) {
  const Verdict verdict = judge(difference, less_is_better);
  const char* kind = verdict == Verdict::better ? "yes" : verdict == Verdict::worse ? "no" : "open";
  return std::string("<span class=\"") + kind + "\">" + html::number(difference) + "</span>";
}

void add_cost_table(const std::vector<const Group*>& round, Document& document) {
  auto ranked = round;
  const auto cost = [](const Group* group) { return estimate(group->metric("slot_cost")).mean; };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&](const Group* a, const Group* b) { return cost(a) < cost(b); });
  std::vector<std::vector<std::string>> rows{{"policy", "cost per 1000", "above the clairvoyant",
                                              "TOCP-DSP minus this", "sent in poor [%]",
                                              "silent in good [%]", "delivered, class low [%]"}};
  const Group& ours = *ours_of(round);
  for (const Group* group : ranked) {
    const auto mean = [&](const char* metric) {
      return html::number(estimate(group->metric(metric)));
    };
    const Estimate difference =
        paired_difference(ours.metric("slot_cost"), group->metric("slot_cost"));
    rows.push_back({display_name(group->policy), mean("slot_cost"), mean("slot_regret"),
                    group == &ours ? "" : coloured(difference, true), mean("sent_in_poor"),
                    mean("silent_in_good"), mean("low_delivered")});
  }
  document.table(rows);
}

void add_cost_figure(const std::vector<const Group*>& round, Document& document) {
  Figure figure("cost_" + round_id(*round.front()),
                mission_name(round.front()->mission) + ": cost above the clairvoyant");
  figure.axes("", "cost per 1000 observations").with("set yrange [0:*]");
  for (const Group* group : round) {
    const Estimate one = estimate(group->metric("slot_regret"));
    figure.interval(display_name(group->policy), one.mean, one.low, one.high);
  }
  document.figure(std::move(figure), "Mean over runs with its 95 % interval; lower is better.");
}

void add_best_table(const std::vector<std::vector<const Group*>>& rounds, Document& document) {
  std::vector<std::vector<std::string>> rows{
      {"set and round", "metric", "best mean", "its policy", "TOCP-DSP", "TOCP-DSP minus best"}};
  for (const auto& round : rounds) {
    const Group& ours = *ours_of(round);
    for (const std::string& metric : contested) {
      const Group* best = best_of(round, metric);
      if (best == nullptr) continue;
      const bool less = metric_texts()[metric_index(metric)].less_is_better;
      const Estimate difference = paired_difference(ours.metric(metric), best->metric(metric));
      rows.push_back({ours.set + ": " + round_title(ours), metric_label(metric),
                      html::number(estimate(best->metric(metric))), display_name(best->policy),
                      html::number(estimate(ours.metric(metric))),
                      best == &ours ? "it is the best" : coloured(difference, less)});
    }
  }
  document.table(rows);
}

}  // namespace

void add_costs(const Results& results, Document& document) {
  const auto rounds = contests(results);
  if (rounds.empty()) return;
  document.heading(2, "Judged by one cost");
  document.paragraph(
      "Latency, age and loss of what is sent all reward silence. The decision library weighs both "
      "errors: an observation spoken in while the link was truly poor costs 1, a silent one while "
      "it was good 0.5, a silent one while it was poor 0.1, and each change 0.5 (its defaults, "
      "<code>decision/costs.hpp</code>; they are a choice of ours, not the thesis's). The truth "
      "is the channel's mean SNR, which no policy sees. The clairvoyant knows it beforehand and "
      "has the least cost that is possible with pauses of at most 30 observations.");
  for (const auto& round : rounds) {
    document.heading(3, round.front()->set + ": " + round_title(*round.front()));
    add_cost_figure(round, document);
    add_cost_table(round, document);
  }
  document.heading(3, "Which policy is best at what");
  document.paragraph(
      "The best mean of each round, and TOCP-DSP beside it; red where TOCP-DSP is worse with 95 % "
      "confidence. The best of several is picked from the same runs, so that it looks a little "
      "better than it is.");
  add_best_table(rounds, document);
}

}  // namespace tocsin::experiment
