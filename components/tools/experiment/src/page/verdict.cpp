// SPDX-License-Identifier: Apache-2.0
#include "page/verdict.hpp"

#include <cctype>
#include <cmath>

#include "page/html.hpp"

namespace tocsin::experiment {

Verdict judge(const Estimate& difference, bool less_is_better) {
  if (difference.below(0)) return less_is_better ? Verdict::better : Verdict::worse;
  if (difference.above(0)) return less_is_better ? Verdict::worse : Verdict::better;
  return Verdict::undecided;
}

const Group* best_of(const std::vector<const Group*>& round, Metric metric) {
  const bool less = text_of(metric).less_is_better;
  const Group* best = nullptr;
  double best_mean = 0;
  for (const Group* group : round) {
    const double mean = estimate(group->metric(metric)).mean;
    if (!std::isfinite(mean)) continue;
    if (best != nullptr && (less ? mean >= best_mean : mean <= best_mean)) continue;
    best = group;
    best_mean = mean;
  }
  return best;
}

std::string verdict_line(const Group& ours, const Group& other,
                         const std::vector<const Group*>& round, Metric metric) {
  const MetricText& text = text_of(metric);
  const auto a = ours.metric(metric);
  const auto b = other.metric(metric);
  const Estimate difference = paired_difference(a, b);
  const Verdict verdict = judge(difference, text.less_is_better);
  const std::string word = verdict == Verdict::better ? "<span class=\"yes\">beats</span>"
                           : verdict == Verdict::worse
                               ? "<span class=\"no\">loses to</span>"
                               : "<span class=\"open\">does not beat</span>";
  std::string line = mission_name(ours.mission) + ": " + display_name(ours.policy) + " " + word +
                     " " + display_name(other.policy) + " on " + text.name + ": " +
                     html::number(estimate(a).mean) + " against " + html::number(estimate(b).mean) +
                     " " + text.unit + ", difference " + html::number(difference) + " over " +
                     std::to_string(difference.runs) + " pairs";
  const Group* best = best_of(round, metric);
  if (verdict != Verdict::better && best != nullptr) {
    line += "; the lowest mean has " + display_name(best->policy) + " with " +
            html::number(estimate(best->metric(metric)).mean);
    if (!text.less_is_better) line.replace(line.find("lowest"), 6, "highest");
  }
  return line + ".";
}

std::string display_name(const std::string& policy) {
  if (policy == "none") return "no policy";
  if (policy == "tocp") return "TOCP";
  if (policy == "tocp_dsp") return "TOCP-DSP";
  return policy;
}

std::string mission_name(const std::string& mission) {
  if (mission.size() != 1) return "Mission " + mission;
  return std::string("Mission ") +
         static_cast<char>(std::toupper(static_cast<unsigned char>(mission[0])));
}

}  // namespace tocsin::experiment
