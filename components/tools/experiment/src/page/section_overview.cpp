// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<Metric> headline_metrics{Metric::user_cost,         Metric::critical_late,
                                           Metric::high_late,         Metric::low_delivered,
                                           Metric::telemetry_per_max, Metric::high_latency_p99,
                                           Metric::probe_per_max};

void add_failures(const Results& results, Document& document) {
  if (results.failures.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < results.failures.size() && i < 20; ++i) {
    list += "<li>" + html::escape(results.failures[i]) + "</li>\n";
  }
  document.paragraph("<span class=\"no\">" + std::to_string(results.failures.size()) +
                     " runs failed</span> and are in no figure:<ul>" + list + "</ul>");
}

void add_round_verdicts(const std::vector<const Group*>& round, Document& document) {
  const Group* ours = nullptr;
  for (const Group* group : round) {
    if (group->policy == "tocp_dsp") ours = group;
  }
  if (ours == nullptr) return;
  document.heading(3, round_title(*ours));
  std::string list;
  for (const Metric metric : headline_metrics) {
    if (best_of(round, metric) == nullptr) continue;  // nobody has an answer
    for (const Group* other : round) {
      if (other == ours) continue;
      list += "<li>" + verdict_line(*ours, *other, round, metric) + "</li>\n";
    }
  }
  document.add("<ul>" + list + "</ul>\n");
}

}  // namespace

std::vector<const RunSet*> sets_of(const Results& results, const std::string& kind) {
  std::vector<const RunSet*> sets;
  for (const RunSet& set : results.experiment.sets) {
    if (set.kind == kind) sets.push_back(&set);
  }
  return sets;
}

std::string round_id(const Group& group) {
  return group.set + "_" + group.mission + "_" + group.channel + "_" + group.payload;
}

std::string round_title(const Group& group) {
  return mission_name(group.mission) + ", channel " + group.channel + ", payload " + group.payload;
}

void add_overview(const Results& results, Document& document) {
  const Timing& timing = results.experiment.timing;
  document.add("<h1>Who may speak while the link is poor: policies compared</h1>\n");
  document.paragraph(
      std::to_string(results.runs) + " runs in simulated time, each of at most " +
      html::number(timing.duration_s) + " s, of which the first " + html::number(timing.warm_up_s) +
      " s do not count; one observation is " + html::number(timing.observation_s) +
      " s. The components are those that drive the vehicle. Run <i>i</i> of a mission on a "
      "channel meets the same radio under every policy and payload, so that differences are "
      "paired. Intervals in brackets are 95 % confidence intervals of the mean over runs "
      "(Student's t). Build " +
      html::escape(results.build) + ".");
  add_failures(results, document);
}

void add_verdicts(const Results& results, Document& document) {
  const auto sets = sets_of(results, "thesis");
  if (sets.empty()) return;
  document.heading(2, "Does TOCP-DSP beat the others?");
  document.paragraph(
      "A line says <i>beats</i> or <i>loses to</i> only where the 95 % interval of "
      "the paired difference leaves out zero.");
  for (const RunSet* set : sets) {
    for (const auto& round : rounds_of(results.groups, set->name)) {
      add_round_verdicts(round, document);
    }
  }
}

void add_definitions(const Results&, Document& document) {
  document.heading(2, "What is measured");
  std::vector<std::vector<std::string>> rows{{"metric", "unit", "definition"}};
  for (const MetricText& text : metric_texts()) {
    rows.push_back({text.name, text.unit, html::escape(text.text)});
  }
  document.table(rows);
  document.paragraph(
      "PER over probes and PER over telemetry are different things: probes are 92-byte packets "
      "both ways, never repaired and never paused; telemetry goes one way, partly repaired, "
      "partly paused. What never arrived is found as gaps in each writer's numbers; a gap's "
      "samples are placed evenly between their neighbours, and losses after the last arrival of a "
      "writer are not seen. Latency is that of samples that arrived.");
}

void add_settings(const Results& results, Document& document) {
  document.heading(2, "Settings");
  document.add(html::details("settings.yaml: build, experiment file, channels, missions, seeds",
                             html::preformatted(results.settings)));
}

}  // namespace tocsin::experiment
