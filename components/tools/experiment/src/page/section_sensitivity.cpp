// SPDX-License-Identifier: Apache-2.0
#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<Metric> swept{Metric::telemetry_per_max,
                                Metric::high_lost,
                                Metric::high_latency_p99,
                                Metric::low_delivered,
                                Metric::detect,
                                Metric::missed,
                                Metric::resume,
                                Metric::sent_in_poor,
                                Metric::silent_in_good,
                                Metric::silence_max};

/// What a policy's entry sets, for the table.
std::string setting_of(const Results& results, const std::string& name) {
  std::string text;
  for (const PolicyChoice& choice : results.experiment.policies) {
    if (choice.name != name) continue;
    for (const std::string& one : choice.set) text += (text.empty() ? "" : " ") + one;
  }
  return html::escape(text);
}

void add_table(const Results& results, const std::vector<const Group*>& round, Document& document) {
  std::vector<std::vector<std::string>> rows{{"variant"}};
  for (const Metric metric : swept) {
    rows[0].push_back(metric_label(metric));
  }
  rows[0].emplace_back("set");
  for (const Group* group : round) {
    std::vector<std::string> row{group->policy};
    for (const Metric metric : swept) {
      row.push_back(html::number(estimate(group->metric(metric))));
    }
    row.push_back(setting_of(results, group->policy));
    rows.push_back(std::move(row));
  }
  document.table(rows);
}

void add_figure(const std::vector<const Group*>& round, Metric metric, Document& document) {
  const std::string name = text_of(metric).name;
  Figure figure("sensitivity_" + round_id(*round.front()) + "_" + name,
                mission_name(round.front()->mission) + ": " + name + " of the variants");
  figure.axes("", metric_label(metric));
  figure.with("set yrange [0:*]");
  for (const Group* group : round) {
    const Estimate one = estimate(group->metric(metric));
    figure.interval(group->policy, one.mean, one.low, one.high);
  }
  document.figure(std::move(figure), "Mean with its 95 % interval.");
}

}  // namespace

void add_sensitivity(const Results& results, Document& document) {
  for (const RunSet* set : sets_of(results, "sensitivity")) {
    document.heading(2, set->title);
    for (const auto& round : rounds_of(results.groups, set->name)) {
      document.heading(3, round_title(*round.front()) + ": " +
                              std::to_string(round.front()->indices.size()) + " runs each");
      for (const Metric metric :
           {Metric::high_latency_p99, Metric::silent_in_good, Metric::sent_in_poor}) {
        add_figure(round, metric, document);
      }
      add_table(results, round, document);
    }
  }
}

}  // namespace tocsin::experiment
