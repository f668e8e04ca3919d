// SPDX-License-Identifier: Apache-2.0
#include "design.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "decision/policy_model.hpp"
#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

using decision::Density;
using decision::PolicyParams;

TradeOff trade_off(const DesignRequest& request, double false_alarm_s) {
  const PolicyParams& p = request.params;
  const bool smooth = p.llr_clip == 0;
  const Density good = good_law_of(p);
  const Density bad = bad_law_of(p);
  const double samples = false_alarm_s / request.period_s;
  const double alpha = alpha_for_run_length(step_law_of(p, good), samples, smooth);
  const double reverse = alpha_for_run_length(reverse_step_law_of(p, bad), samples, smooth);
  return {false_alarm_s, alpha,
          mean_run_length(step_law_of(p, bad), alpha, smooth) * request.period_s, reverse,
          mean_run_length(reverse_step_law_of(p, good), reverse, smooth) * request.period_s};
}

std::vector<TradeOff> table_of(const DesignRequest& request) {
  std::vector<TradeOff> table;
  for (const double s : {600., 3600., 6 * 3600., 86400., 7 * 86400., 30 * 86400.}) {
    try {
      table.push_back(trade_off(request, s));
    } catch (const ConfigError&) {
      continue;  // shorter than what the smallest threshold gives: not a choice
    }
  }
  return table;
}

std::vector<ShiftDelay> shifts_of(const DesignRequest& request, double alpha) {
  const PolicyParams& p = request.params;
  std::vector<ShiftDelay> shifts;
  if (good_law_of(p).family() != decision::Family::normal) return shifts;
  const double sd = good_law_of(p).parameters()[1];
  const double mean = good_law_of(p).parameters()[0];
  for (const double x : {40., 50., 55., 60., 65., 70., 75.}) {
    if (x >= mean) continue;
    const Density truth(decision::Family::normal, {x, sd, 0});
    shifts.push_back(
        {x, mean_run_length(step_law_of(p, truth), alpha, p.llr_clip == 0) * request.period_s});
  }
  return shifts;
}

nlohmann::json to_json(const TradeOff& one) {
  return {{"false_alarm_s", one.false_alarm_s},
          {"alpha", one.alpha},
          {"delay_s", one.delay_s},
          {"reverse_alpha", one.reverse_alpha},
          {"reverse_delay_s", one.reverse_delay_s}};
}

}  // namespace

Design design(const DesignRequest& request) {
  Design result{request, trade_off(request, request.false_alarm_s), {}, {}, {}};
  if (request.recording) {
    result.calibration =
        calibrate_on(*request.recording, {request.params, request.false_alarm_s, request.block_s,
                                          request.seed, request.replicates, request.paths});
  }
  result.table = table_of(request);
  result.shifts = shifts_of(request, result.wanted.alpha);
  return result;
}

std::string to_text(const Design& design) {
  std::ostringstream text;
  const TradeOff& w = design.wanted;
  text << "one sample per " << design.request.period_s << " s, a false alarm per "
       << duration_text(w.false_alarm_s) << " of independent samples:\n"
       << "  alpha " << w.alpha << ", mean delay " << duration_text(w.delay_s)
       << " when the network turns bad\n"
       << "  reverse_alpha " << w.reverse_alpha << ", mean delay "
       << duration_text(w.reverse_delay_s) << " when it turns good\n";
  if (design.calibration) text << to_text(*design.calibration);
  text << "\n  false alarm      alpha      delay  reverse_alpha      delay\n";
  for (const TradeOff& one : design.table) {
    text << std::setw(13) << duration_text(one.false_alarm_s) << std::setw(11) << one.alpha
         << std::setw(11) << duration_text(one.delay_s) << std::setw(15) << one.reverse_alpha
         << std::setw(11) << duration_text(one.reverse_delay_s) << '\n';
  }
  text << (design.shifts.empty() ? "" : "\n  quality settles at   mean delay\n");
  for (const ShiftDelay& one : design.shifts) {
    text << std::setw(20) << one.mean << std::setw(13) << duration_text(one.delay_s) << '\n';
  }
  return text.str();
}

nlohmann::json to_json(const Design& design) {
  nlohmann::json out = to_json(design.wanted);
  out["period_s"] = design.request.period_s;
  out["table"] = nlohmann::json::array();
  for (const TradeOff& one : design.table) out["table"].push_back(to_json(one));
  out["shifts"] = nlohmann::json::array();
  for (const ShiftDelay& one : design.shifts) {
    out["shifts"].push_back({{"mean", one.mean}, {"delay_s", one.delay_s}});
  }
  if (design.calibration) out["calibration"] = to_json(*design.calibration);
  return out;
}

}  // namespace tocsin::tools
