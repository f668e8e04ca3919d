// SPDX-License-Identifier: Apache-2.0
// The thesis's evaluation redone: figures 43 to 52 and its tables.
#include <algorithm>
#include <cmath>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

const std::vector<std::string> thesis_policies{"none", "threshold", "tocp", "tocp_dsp"};

double qni(const Observation& one) { return one.qni; }
double probe_per(const Observation& one) { return one.probe_per; }
double latency(const Observation& one) { return one.latency_ms; }

/// Maxima and means that the thesis prints (reference: its chapter of results; maxima without
/// intervals). NaN where it gives none.
struct ThesisNumbers {
  const char* mission;
  const char* policy;
  double per_max;
  double qni_mean;
};
const ThesisNumbers thesis_numbers[] = {
    {"a", "none", 25, std::nan("")}, {"a", "threshold", 45, std::nan("")},
    {"a", "tocp", 15, std::nan("")}, {"a", "tocp_dsp", 10, std::nan("")},
    {"b", "none", 30, 68.4},         {"b", "threshold", 20, 70.8},
    {"b", "tocp", 20, 65.9},         {"b", "tocp_dsp", 10, 76.3},
};

const ThesisNumbers* thesis_number(const Group& group) {
  for (const ThesisNumbers& one : thesis_numbers) {
    if (group.mission == one.mission && group.policy == one.policy) return &one;
  }
  return nullptr;
}

double largest(const std::vector<double>& values) {
  double result = std::nan("");
  for (const double value : values) {
    if (!(value <= result)) result = std::isfinite(value) ? value : result;
  }
  return result;
}

void add_qni_figure(const Group& ours, const Group& other, int number, Document& document) {
  Figure figure(
      "fig" + std::to_string(number) + "_" + round_id(ours) + "_" + other.policy,
      mission_name(ours.mission) + ": QNI with TOCP-DSP and with " + display_name(other.policy));
  figure.axes("observation", "QNI [%]").with("set yrange [0:100]");
  for (const Group* group : {&ours, &other}) {
    figure.band(percentile_series(*group, qni, 0.1), percentile_series(*group, qni, 0.9), 1);
    figure.line(display_name(group->policy), mean_series(*group, qni), 1);
  }
  document.figure(std::move(figure), "As figure " + std::to_string(number) +
                                         " of the thesis: mean over " +
                                         std::to_string(ours.indices.size()) +
                                         " runs; shaded: 10th to 90th percentile of the runs.");
}

void add_per_figure(const std::vector<const Group*>& round, int number, Document& document) {
  Figure figure("fig" + std::to_string(number) + "_" + round_id(*round.front()) + "_per",
                mission_name(round.front()->mission) + ": packet error rate of the four policies");
  figure.axes("observation", "PER over probes [%]").with("set yrange [0:*]");
  for (const std::string& policy : thesis_policies) {
    for (const Group* group : round) {
      if (group->policy != policy) continue;
      figure.line(display_name(policy), mean_series(*group, probe_per), 1);
    }
  }
  document.figure(std::move(figure), "As figure " + std::to_string(number) +
                                         " of the thesis: share of 20 ICMP echoes without an "
                                         "answer, mean over runs at the same observation.");
}

void add_latency_figure(const Group& ours, const Group& none, int number, Document& document) {
  Figure figure("fig" + std::to_string(number) + "_" + round_id(ours) + "_latency",
                mission_name(ours.mission) + ": latency with TOCP-DSP and without a policy");
  figure.axes("observation", "latency of telemetry [ms]").with("set logscale y");
  for (const Group* group : {&ours, &none}) {
    figure.band(percentile_series(*group, latency, 0.1), percentile_series(*group, latency, 0.9),
                1);
    figure.line(display_name(group->policy), mean_series(*group, latency), 1);
  }
  document.figure(std::move(figure),
                  "As figure " + std::to_string(number) +
                      " of the thesis: median of the telemetry of an observation, mean over runs; "
                      "shaded: 10th to 90th percentile.");
}

void add_table(const std::vector<const Group*>& round, Document& document) {
  std::vector<std::vector<std::string>> rows{
      {"policy", "max PER, thesis [%]", "max PER over probes, ours [%]",
       "peak of the mean curve, ours [%]", "max PER of telemetry, ours [%]", "mean QNI, thesis [%]",
       "mean QNI, ours [%]"}};
  for (const std::string& policy : thesis_policies) {
    for (const Group* group : round) {
      if (group->policy != policy) continue;
      const ThesisNumbers* thesis = thesis_number(*group);
      rows.push_back({display_name(policy), html::number(thesis ? thesis->per_max : std::nan("")),
                      html::number(estimate(group->metric(Metric::probe_per_max))),
                      html::number(largest(mean_series(*group, probe_per))),
                      html::number(estimate(group->metric(Metric::telemetry_per_max))),
                      html::number(thesis ? thesis->qni_mean : std::nan("")),
                      html::number(estimate(group->metric(Metric::qni_mean)))});
    }
  }
  document.table(rows);
}

void add_latency_sentence(const Group& ours, const Group& none, Document& document) {
  const auto a = ours.metric(Metric::high_latency_median);
  const auto b = none.metric(Metric::high_latency_median);
  const Estimate difference = paired_difference(a, b);
  const double change = 100 * difference.mean / estimate(b).mean;
  document.paragraph(
      "Latency: the thesis tells 24 % less with TOCP-DSP in Mission A. Here the "
      "median latency of class high is " +
      html::number(estimate(a)) + " ms against " + html::number(estimate(b)) +
      " ms without a policy: " + html::number(change) + " %.");
}

/// Numbers 43 to 47 for the first mission, 48 to 52 for the second.
void add_round(const std::vector<const Group*>& round, int first, Document& document) {
  const auto of = [&](const std::string& policy) {
    const auto found = std::find_if(round.begin(), round.end(),
                                    [&](const Group* group) { return group->policy == policy; });
    return found == round.end() ? nullptr : *found;
  };
  document.heading(3, round_title(*round.front()));
  const Group* ours = of("tocp_dsp");
  int number = first;
  for (const char* other : {"none", "threshold", "tocp"}) {
    if (ours != nullptr && of(other) != nullptr) {
      add_qni_figure(*ours, *of(other), number, document);
    }
    ++number;
  }
  add_per_figure(round, number++, document);
  if (ours != nullptr && of("none") != nullptr) {
    add_latency_figure(*ours, *of("none"), number, document);
    add_latency_sentence(*ours, *of("none"), document);
  }
  add_table(round, document);
}

}  // namespace

void add_thesis(const Results& results, Document& document) {
  const auto sets = sets_of(results, "thesis");
  if (sets.empty()) return;
  document.heading(2, "The thesis's figures 43 to 52");
  for (const RunSet* set : sets) {
    int first = 43;
    for (const auto& round : rounds_of(results.groups, set->name)) {
      add_round(round, first, document);
      first = first == 43 ? 48 : 43;
    }
  }
  document.paragraph(
      "Where the numbers differ, and why. The thesis prints maxima of one series per policy, "
      "without intervals; a maximum over about a hundred observations of 20 probes moves in steps "
      "of 5 % and by chance alone, so a single one says little. The link that the thesis's probes "
      "met is not known; ours was chosen so that no policy meets about its PER. Its source lets "
      "every DSP pause last three or four samples, whatever the network does, and its TOCP is a "
      "threshold on one sample; ours are the rules of its text. Probes are never paused: a policy "
      "lowers the PER over probes only as far as silence empties the queue before them, and "
      "cannot mend a weak signal.");
}

}  // namespace tocsin::experiment
