// SPDX-License-Identifier: Apache-2.0
#include "decide_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "foundation/printable.hpp"

namespace tocsin::tools {
namespace {

using decision::Evidence;
using decision::State;

/// A number for CSV; empty when it is none.
std::string cell(double value) {
  if (!std::isfinite(value)) return "";
  std::ostringstream text;
  text << std::setprecision(10) << value;
  return text.str();
}

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json row(const Step& step) {
  const Evidence& one = step.evidence;
  return {{"time_s", step.time_s},
          {"qni", number(one.sample)},
          {"state", to_string(one.state)},
          {"reason", to_string(one.reason)},
          {"statistic", number(one.statistic)},
          {"threshold", number(one.threshold)},
          {"age", one.age}};
}

std::string changes_text(const DecidedTrace& decided) {
  std::ostringstream text;
  text << "      time_s  state    qni     statistic  threshold  age  reason\n" << std::fixed;
  for (const Step& step : decided.steps) {
    const Evidence& one = step.evidence;
    if (!one.changed) continue;
    text << std::setw(12) << std::setprecision(1) << step.time_s << "  " << std::left
         << std::setw(8) << to_string(one.state) << std::right << std::setprecision(2)
         << std::setw(6) << one.sample << std::setw(12) << one.statistic << std::setw(11)
         << one.threshold << std::setw(5) << one.age << "  " << to_string(one.reason) << '\n';
  }
  return text.str();
}

/// Empty sets of samples have no mean.
std::string mean_text(double mean) {
  return std::isnan(mean) ? "none" : fmt::format("{:.1f}", mean);
}

std::string words_of(bool active, const std::string& reason) {
  return std::string(active ? "active, " : "passive, ") + printable(reason);
}

/// The first decision that is not the recorded one.
std::string first_other_text(const DecidedTrace& decided, std::size_t row) {
  const RecordedDecision& recorded = decided.trace.recorded[row];
  std::string now = "nothing";
  for (const Step& step : decided.steps) {
    if (step.row != row) continue;
    now = words_of(step.evidence.state == State::active, to_string(step.evidence.reason));
  }
  return fmt::format("the first other one at {:.1f} s: recorded {}; decided {}",
                     decided.trace.time_s[row], words_of(recorded.active, recorded.reason), now);
}

/// Empty when the trace is no recording of decisions.
std::string comparison_text(const DecidedTrace& decided) {
  const auto compared = compare_with_recording(decided);
  if (!compared) return "";
  std::string text =
      fmt::format("recorded were {} pauses; {} of {} decisions are the recorded ones",
                  compared->recorded_pauses, compared->same, compared->recorded);
  if (compared->first_other) text += ", " + first_other_text(decided, *compared->first_other);
  text += "\n";
  if (decided.trace.unrecorded > 0) {
    text += fmt::format(
        "{} decisions of the run are not in this recording; those that follow one may differ\n",
        decided.trace.unrecorded);
  }
  return text;
}

nlohmann::json parameters_json(const PolicySettings& settings) {
  nlohmann::json all = nlohmann::json::array();
  for (const ParameterSource& source : settings.sources) {
    nlohmann::json values = nlohmann::json::object();
    for (const auto& [key, value] : source.values) values[key] = value;
    all.push_back({{"from", source.name}, {"values", values}});
  }
  return all;
}

/// What a recording adds to the summary.
void add_recording(const DecidedTrace& decided, nlohmann::json& out) {
  const auto compared = compare_with_recording(decided);
  if (!compared) return;
  if (const auto role = decided.trace.role) out["role"] = to_string(*role);
  out["recorded"] = {{"began_s", decided.trace.began_s},
                     {"decisions", compared->recorded},
                     {"pauses", compared->recorded_pauses},
                     {"same", compared->same},
                     {"unrecorded", decided.trace.unrecorded}};
}

}  // namespace

std::string to_text(const DecidedTrace& decided) {
  const DecisionSummary s = summarize(decided);
  const auto samples = static_cast<double>(std::max<std::size_t>(s.samples, 1));
  const auto role = decided.trace.role;
  std::ostringstream text;
  text << changes_text(decided) << std::fixed << std::setprecision(1);
  text << "\npolicy " << decided.policy << " on " << decided.trace.path << " ("
       << decided.trace.kind << (role ? std::string(" of role ") + to_string(*role) : "") << ")\n"
       << to_text(decided.settings) << s.samples << " samples, " << s.missing
       << " without measurement; " << s.pauses << " pauses, " << s.forced
       << " ended by a limit, longest " << s.longest_pause << " samples; silent "
       << 100.0 * static_cast<double>(s.passive) / samples << " %\nmean QNI while active "
       << mean_text(s.mean_qni_active) << ", while passive " << mean_text(s.mean_qni_passive)
       << '\n';
  text << comparison_text(decided);
  if (s.has_truth) {
    text << "cost " << s.cost << ", clairvoyant " << s.oracle_cost << ", regret "
         << s.cost - s.oracle_cost << '\n';
  }
  return text.str();
}

nlohmann::json to_json(const DecidedTrace& decided, bool rows) {
  const DecisionSummary s = summarize(decided);
  nlohmann::json changes = nlohmann::json::array();
  for (const Step& step : decided.steps) {
    if (rows || step.evidence.changed) changes.push_back(row(step));
  }
  nlohmann::json out{{"file", decided.trace.path},
                     {"kind", decided.trace.kind},
                     {"policy", decided.policy},
                     {"parameters", parameters_json(decided.settings)},
                     {"samples", s.samples},
                     {"missing", s.missing},
                     {"pauses", s.pauses},
                     {"forced", s.forced},
                     {"longest_pause_samples", s.longest_pause},
                     {"passive_samples", s.passive},
                     {"mean_qni_active", number(s.mean_qni_active)},
                     {"mean_qni_passive", number(s.mean_qni_passive)},
                     {rows ? "rows" : "changes", changes}};
  add_recording(decided, out);
  if (s.has_truth) out["cost"] = s.cost;
  if (s.has_truth) out["oracle_cost"] = s.oracle_cost;
  return out;
}

std::string to_csv(const DecidedTrace& decided) {
  const std::vector<bool>& bad = decided.trace.bad;
  std::string text = "time_s,qni,active,reason,statistic,threshold,age";
  text += bad.empty() ? "\n" : ",state\n";
  std::size_t row = 0;
  for (const Step& step : decided.steps) {
    const Evidence& one = step.evidence;
    text += cell(step.time_s) + ',' + cell(one.sample) + ',' +
            (one.state == State::active ? "1," : "0,") + to_string(one.reason) + ',' +
            cell(one.statistic) + ',' + cell(one.threshold) + ',' + std::to_string(one.age);
    row = step.row.value_or(row);  // a pause that ended between two rows: as at the one before
    if (!bad.empty()) text += bad[row] ? ",1" : ",0";
    text += '\n';
  }
  return text;
}

nlohmann::json decide_plot(const DecidedTrace& decided) {
  const auto line = [&](const char* name, double (*value)(const Evidence&), const char* style) {
    nlohmann::json one{{"name", name}, {"style", style}, {"x", nlohmann::json::array()}};
    one["y"] = nlohmann::json::array();
    for (const Step& step : decided.steps) {
      one["x"].push_back(step.time_s);
      one["y"].push_back(number(value(step.evidence)));
    }
    return one;
  };
  const auto silent = [](const Evidence& one) { return one.state == State::passive ? 100.0 : 0; };
  const nlohmann::json quality{
      {"y", "QNI"},
      {"range", {0, 100}},
      {"lines",
       {line("passive", silent, "area"),
        line(
            "QNI", [](const Evidence& one) { return one.sample; }, "line")}}};
  const nlohmann::json statistic{
      {"y", "statistic"},
      {"lines",
       {line(
            "statistic", [](const Evidence& one) { return one.statistic; }, "line"),
        line(
            "threshold", [](const Evidence& one) { return one.threshold; }, "line")}}};
  return {{"title", "policy " + decided.policy + ", " + decided.trace.path},
          {"x", "s"},
          {"panels", {quality, statistic}}};
}

}  // namespace tocsin::tools
