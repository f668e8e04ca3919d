// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "page/sections.hpp"
#include "page/verdict.hpp"

namespace tocsin::experiment {
namespace {

/// What the table of a comparison shows; runs.csv has them all.
const std::vector<Metric> compared{Metric::user_cost,
                                   Metric::critical_late,
                                   Metric::critical_very_late,
                                   Metric::high_late,
                                   Metric::high_very_late,
                                   Metric::qni_mean,
                                   Metric::probe_per_mean,
                                   Metric::probe_per_max,
                                   Metric::telemetry_per,
                                   Metric::telemetry_per_max,
                                   Metric::critical_lost,
                                   Metric::high_lost,
                                   Metric::goals_lost,
                                   Metric::low_lost,
                                   Metric::camera_lost,
                                   Metric::high_delivered,
                                   Metric::low_delivered,
                                   Metric::critical_latency_median,
                                   Metric::critical_latency_p99,
                                   Metric::high_latency_median,
                                   Metric::high_latency_p99,
                                   Metric::low_latency_p99,
                                   Metric::picture_latency_p99,
                                   Metric::goal_latency_p99,
                                   Metric::location_age_mean,
                                   Metric::location_age_p95,
                                   Metric::location_age_p99,
                                   Metric::battery_age_mean,
                                   Metric::battery_age_p95,
                                   Metric::camera_age_mean,
                                   Metric::heartbeat_age_mean,
                                   Metric::state_age_mean,
                                   Metric::cpu_age_mean,
                                   Metric::link_bytes,
                                   Metric::airtime,
                                   Metric::detect,
                                   Metric::missed,
                                   Metric::resume,
                                   Metric::sent_in_poor,
                                   Metric::silent_in_good,
                                   Metric::pauses,
                                   Metric::silence_mean,
                                   Metric::silence_max,
                                   Metric::completion};

const std::vector<Metric> boxed{Metric::user_cost,
                                Metric::critical_late,
                                Metric::high_late,
                                Metric::location_age_p99,
                                Metric::telemetry_per_max,
                                Metric::probe_per_max,
                                Metric::high_latency_p99,
                                Metric::location_age_p95,
                                Metric::silence_mean,
                                Metric::silence_max,
                                Metric::detect,
                                Metric::resume,
                                Metric::completion};

void add_means(const std::vector<const Group*>& round, Document& document) {
  std::vector<std::vector<std::string>> rows{{"mean over runs"}};
  for (const Group* group : round) rows[0].push_back(display_name(group->policy));
  for (const Metric metric : compared) {
    std::vector<std::string> row{metric_label(metric)};
    bool any = false;
    for (const Group* group : round) {
      const Estimate one = estimate(group->metric(metric));
      any = any || one.runs > 0;
      row.push_back(html::number(one));
    }
    if (any) rows.push_back(std::move(row));
  }
  document.table(rows);
}

/// Ours minus the other's, coloured where the interval leaves out zero.
std::string difference_cell(const Group& ours, const Group& other, Metric metric) {
  const Estimate one = paired_difference(ours.metric(metric), other.metric(metric));
  const Verdict verdict = judge(one, text_of(metric).less_is_better);
  const char* kind = verdict == Verdict::better ? "yes" : verdict == Verdict::worse ? "no" : "";
  return std::string("<span class=\"") + kind + "\">" + html::number(one) + "</span>";
}

void add_differences(const std::vector<const Group*>& round, const Group& ours,
                     Document& document) {
  std::vector<std::vector<std::string>> rows{{"TOCP-DSP minus ..."}};
  for (const Group* group : round) {
    if (group != &ours) rows[0].push_back(display_name(group->policy));
  }
  for (const Metric metric : compared) {
    std::vector<std::string> row{metric_label(metric)};
    for (const Group* group : round) {
      if (group == &ours) continue;
      row.push_back(difference_cell(ours, *group, metric));
    }
    rows.push_back(std::move(row));
  }
  document.add(
      html::details("paired differences (green: better, red: worse, with 95 % "
                    "confidence)",
                    html::table(rows)));
}

void add_round(const std::vector<const Group*>& round, Document& document) {
  document.heading(3, round_title(*round.front()) + ": " +
                          std::to_string(round.front()->indices.size()) + " runs each");
  add_means(round, document);
  for (const Group* group : round) {
    if (group->policy == "tocp_dsp" && round.size() > 1) {
      add_differences(round, *group, document);
    }
  }
}

/// Means of several metrics, one place on the x axis each, side by side for the policies.
struct Board {
  const char* name;
  const char* title;
  const char* y_axis;
  std::vector<std::pair<std::string, Metric>> metrics;  ///< label, metric
  const char* caption;
};

const Board ages{
    "ages",
    "age of information at the ground station",
    "mean age [s]",
    {{"location", Metric::location_age_mean},
     {"network quality", Metric::quality_age_mean},
     {"heartbeat", Metric::heartbeat_age_mean},
     {"transmission state", Metric::state_age_mean},
     {"battery (low)", Metric::battery_age_mean},
     {"CPU load (low)", Metric::cpu_age_mean},
     {"camera (low)", Metric::camera_age_mean}},
    "Age of the newest received sample of each topic, mean over time and runs with its "
    "95 % interval. Network quality is measured every six seconds."};
const Board lateness{"lateness",
                     "too late or never",
                     "late or lost [%]",
                     {{"critical, 250 ms", Metric::critical_late},
                      {"critical, 1 s", Metric::critical_very_late},
                      {"critical, never", Metric::critical_lost},
                      {"high, 250 ms", Metric::high_late},
                      {"high, 1 s", Metric::high_very_late},
                      {"high, never", Metric::high_lost}},
                     "Share of samples put on the link that came later than that or never, mean "
                     "over runs with its 95 % interval."};
const Board losses{"losses",
                   "lost of what was sent, by class",
                   "lost [%]",
                   {{"critical", Metric::critical_lost},
                    {"high", Metric::high_lost},
                    {"low, no camera", Metric::low_lost},
                    {"camera", Metric::camera_lost},
                    {"goals", Metric::goals_lost}},
                   "Share of samples put on the link that never arrived, mean over runs with its "
                   "95 % interval; what the gate held back was not sent."};

void add_board(const std::vector<const Group*>& round, const Board& board, Document& document) {
  Figure figure(std::string(board.name) + "_" + round_id(*round.front()),
                mission_name(round.front()->mission) + ": " + board.title);
  figure.axes("", board.y_axis).with("set yrange [0:*]");
  std::vector<std::string> labels;
  for (const auto& [label, metric] : board.metrics) labels.push_back(label);
  figure.categories(labels);
  const double width = 0.6 / static_cast<double>(round.size());
  for (std::size_t i = 0; i < round.size(); ++i) {
    std::vector<Estimate> means;
    for (const auto& [label, metric] : board.metrics) {
      means.push_back(estimate(round[i]->metric(metric)));
    }
    figure.marks(display_name(round[i]->policy), means, width * static_cast<double>(i) - 0.3);
  }
  document.figure(std::move(figure), board.caption);
}

void add_boxes(const std::vector<const Group*>& round, Metric metric, Document& document) {
  const std::string name = text_of(metric).name;
  Figure figure("box_" + round_id(*round.front()) + "_" + name,
                mission_name(round.front()->mission) + ": " + name + " over runs");
  const MetricText& text = text_of(metric);
  figure.axes("", metric_label(metric));
  figure.with("set yrange [0:*]");
  for (const Group* group : round) figure.box(display_name(group->policy), group->metric(metric));
  document.figure(std::move(figure), std::string("Box: quartiles and median over ") +
                                         std::to_string(round.front()->indices.size()) +
                                         " runs; whiskers: 5th to 95th percentile. " +
                                         html::escape(text.text) + ".");
}

}  // namespace

void add_distributions(const Results& results, Document& document) {
  const auto sets = sets_of(results, "thesis");
  if (sets.empty()) return;
  document.heading(2, "Distributions over runs");
  for (const RunSet* set : sets) {
    for (const auto& round : rounds_of(results.groups, set->name)) {
      document.heading(3, round_title(*round.front()));
      for (const Board* board : {&lateness, &ages, &losses}) add_board(round, *board, document);
      for (const Metric metric : boxed) add_boxes(round, metric, document);
    }
  }
}

void add_comparisons(const Results& results, Document& document) {
  for (const char* kind : {"thesis", "comparison"}) {
    for (const RunSet* set : sets_of(results, kind)) {
      document.heading(2, set->title);
      for (const auto& round : rounds_of(results.groups, set->name)) add_round(round, document);
    }
  }
}

}  // namespace tocsin::experiment
