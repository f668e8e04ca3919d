// SPDX-License-Identifier: Apache-2.0
// What it is worth to learn the law of a site's good link on the vehicle.
// usage: site_learning [ROUNDS [TRACE.csv...]]
//   ROUNDS of each site, one after the other, of which the last one counts [10];
//   each TRACE (columns qni and state, 1 is bad) is a site, without one: six simulated sites.
//
// Leave one out: each site in turn is the one that nobody has seen, and laws come from the thesis,
// from all other sites, or are learned in its own rounds from either. Regret over the clairvoyant
// in 1000 slots (decision library's SlotCosts), with the half width of its 95 % interval over
// drives. A second table lets a building drift for hours, with bad spells; a third has a fault that
// looks half good while laws are learned.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "decision/policy_model.hpp"
#include "decision/research/scenario.hpp"
#include "foundation/csv_table.hpp"

namespace tocsin::decision {
namespace {

using Trace = SimulatedTrace;

/// A place and drives in it.
struct Site {
  std::string name;
  std::vector<Trace> drives;
};

constexpr int drives_of_a_simulated_site = 20;
constexpr int slots_of_a_drive = 600;

Site simulated(const char* name, Normal good, Normal bad) {
  const Scenario scenario{name, 120, 20, good, bad, 0.8, 5};
  Site site{name, {}};
  for (unsigned seed = 1; seed <= drives_of_a_simulated_site; ++seed) {
    site.drives.push_back(simulate(scenario, slots_of_a_drive, seed));
  }
  return site;
}

std::vector<Site> simulated_sites() {
  return {
      simulated("thesis's", thesis_good, thesis_bad), simulated("demo's", {77.5, 11}, {52.5, 9}),
      simulated("hall", {90, 5}, {45, 10}),           simulated("stone walls", {72, 8}, {37, 7}),
      simulated("cellar", {66, 7}, {40, 8}),          simulated("yard", {85, 12}, {30, 10})};
}

Site recorded(const std::string& path) {
  const CsvTable table = CsvTable::load(path);
  Trace trace{table.numbers("qni"), {}};
  for (const double state : table.numbers("state")) trace.bad.push_back(state > 0.5);
  std::string name = path.substr(path.find_last_of('/') + 1);
  return {name.substr(0, name.rfind(".csv")), {trace}};
}

/// Mean and spread of the qualities in good or bad slots; `otherwise` when there are too few.
Normal law(const std::vector<const Site*>& sites, bool bad, const Normal& otherwise) {
  double n = 0;
  double sum = 0;
  double squares = 0;
  for (const Site* site : sites) {
    for (const Trace& trace : site->drives) {
      for (std::size_t i = 0; i < trace.qni.size(); ++i) {
        if (trace.bad[i] != bad || std::isnan(trace.qni[i])) continue;
        ++n;
        sum += trace.qni[i];
        squares += trace.qni[i] * trace.qni[i];
      }
    }
  }
  if (n < 20) return otherwise;
  const double mean = sum / n;
  return {mean, std::max(1.0, std::sqrt(squares / n - mean * mean))};
}

PolicyParams base(const char* policy) {
  PolicyParams params;
  params.policy = policy;
  params.th_max_s = 86400;  // samples count
  return params;
}

/// The parameters with laws fitted to these sites and thresholds of the same false-alarm time.
PolicyParams fitted(PolicyParams params, const std::vector<const Site*>& sites) {
  const double alarms = false_alarm_samples_of(params);
  const Normal bad = law(sites, true, thesis_bad);
  const Normal good = law(sites, false, thesis_good);
  params.good_mean = good.mean;
  params.good_sd = good.sd;
  params.bad_mean = bad.mean;
  params.bad_sd = bad.sd;
  params.alpha = rough_alpha_for_run_length(step_law_of(params, good_law_of(params)), alarms)
                     .value_or(params.alpha);
  return params;
}

PolicyParams applying(PolicyParams params) {
  params.laws = "apply";
  return params;
}

/// Of the last of the rounds, per 1000 slots.
double regret(const Trace& trace, int rounds, const PolicyParams& params) {
  const SlotCosts costs;
  std::vector<double> qualities;
  for (int i = 0; i < rounds; ++i) {
    qualities.insert(qualities.end(), trace.qni.begin(), trace.qni.end());
  }
  const auto policy = make_policy(params);
  const std::vector<bool> all = decide(*policy, qualities);
  const auto slots = slots_of(trace.bad, costs);
  const auto size = static_cast<std::ptrdiff_t>(slots.size());
  const double cost = cost_of(slots, costs.change, {all.end() - size, all.end()});
  return 1000 * (cost - clairvoyant(slots, costs.change, params.th_max_samples).cost) /
         static_cast<double>(size);
}

/// A way to come by laws, for the site that is left out.
struct Source {
  const char* name;
  PolicyParams (*laws)(const PolicyParams& params, const Site& site,
                       const std::vector<const Site*>& others);
};

const Source sources[] = {
    {"the thesis's", [](const PolicyParams& p, const Site&, const auto&) { return p; }},
    {"the thesis's, then learned",
     [](const PolicyParams& p, const Site&, const auto&) { return applying(p); }},
    {"fitted on all others",
     [](const PolicyParams& p, const Site&, const auto& others) { return fitted(p, others); }},
    {"fitted on all others, then learned",
     [](const PolicyParams& p, const Site&, const auto& others) {
       return applying(fitted(p, others));
     }},
    {"fitted on the site itself",
     [](const PolicyParams& p, const Site& site, const auto&) { return fitted(p, {&site}); }}};

std::vector<const Site*> all_but(const std::vector<Site>& sites, const Site& left_out) {
  std::vector<const Site*> others;
  for (const Site& site : sites) {
    if (&site != &left_out) others.push_back(&site);
  }
  return others;
}

void print_cell(const Site& site, int rounds, const PolicyParams& params) {
  std::vector<double> values;
  for (const Trace& trace : site.drives) values.push_back(regret(trace, rounds, params));
  const Estimate result = estimate(values);
  std::printf(" %.0f", result.mean);
  if (values.size() > 1)
    std::printf(" +-%.0f", 2.09 * result.standard_error);  // Student, 20 drives
  std::printf(" |");
}

void print_head(const char* first, const std::vector<Site>& sites) {
  std::printf("| %s |", first);
  for (const Site& site : sites) std::printf(" %s |", site.name.c_str());
  std::printf("\n| --- |");
  for (std::size_t i = 0; i < sites.size(); ++i) std::printf(" --- |");
  std::printf("\n");
}

void leave_one_out(const std::vector<Site>& sites, int rounds) {
  for (const char* policy : {"tocp_reverse", "tocp_dsp"}) {
    std::printf("\n%s, regret in round %d:\n\n", policy, rounds);
    print_head("laws", sites);
    for (const Source& source : sources) {
      std::printf("| %s |", source.name);
      for (const Site& site : sites) {
        print_cell(site, rounds, source.laws(base(policy), site, all_but(sites, site)));
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("| no policy |");
  for (const Site& site : sites) print_cell(site, rounds, base("none"));
  std::printf("\n");
}

/// What a policy does on a long drive.
struct Account {
  double false_pauses = 0;  ///< begun in good slots
  double spells = 0;
  double delay = 0;  ///< [samples] of all spells; their length when they are not found
  double cost = 0;
};

Account account(const Trace& trace, const PolicyParams& params) {
  const SlotCosts costs;
  const auto policy = make_policy(params);
  const std::vector<bool> send = decide(*policy, trace.qni);
  Account result;
  bool found = true;
  for (std::size_t n = 1; n < send.size(); ++n) {
    if (trace.bad[n] && !trace.bad[n - 1]) {
      ++result.spells;
      found = !send[n];
    }
    if (!trace.bad[n]) found = true;
    found |= !send[n];
    result.delay += !found;
    result.false_pauses += send[n - 1] && !send[n] && !trace.bad[n] && !trace.bad[n - 1];
  }
  result.cost = cost_of(slots_of(trace.bad, costs), costs.change, send);
  return result;
}

/// Bad spells as in S1, ten times as rare, in a building whose good law goes from the thesis's to
/// `to` in six hours and stays there for four.
Trace drifting(double correlation, Normal to, std::uint64_t seed) {
  constexpr int hours = 10;
  const Scenario scenario{"drift", 1200, 20, {0, 1}, {0, 1}, correlation, 1};
  Trace trace =
      simulate({"deviations", 1e9, 1.1, {50, 10}, {50, 10}, correlation, 1}, hours * 3600, seed);
  trace.bad = simulate(scenario, hours * 3600, seed + 1000).bad;
  for (std::size_t n = 0; n < trace.qni.size(); ++n) {
    const double share = std::min(1.0, static_cast<double>(n) / (6 * 3600));
    const Normal good{thesis_good.mean + share * (to.mean - thesis_good.mean),
                      thesis_good.sd + share * (to.sd - thesis_good.sd)};
    const Normal& now = trace.bad[n] ? thesis_bad : good;
    trace.qni[n] = std::clamp(now.mean + now.sd * (trace.qni[n] - 50) / 10, 0.0, 100.0);
  }
  return trace;
}

void print_drift(const char* name, double correlation, Normal to, const PolicyParams& params) {
  constexpr int drives = 10;
  Account sum;
  double hours = 0;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    const Trace trace = drifting(correlation, to, seed);
    const Account one = account(trace, params);
    sum.false_pauses += one.false_pauses;
    sum.spells += one.spells;
    sum.delay += one.delay;
    sum.cost += one.cost;
    hours += static_cast<double>(trace.qni.size()) / 3600;
  }
  std::printf("| %.1f +-%.1f, correlation %.1f | %s | %.2f | %.2f | %.1f |\n", to.mean, to.sd,
              correlation, name, sum.false_pauses / hours, sum.delay / sum.spells,
              1000 * sum.cost / (hours * 3600));
}

void drift() {
  std::printf(
      "\n| building drifts to | laws | false pauses an hour | delay, samples | cost in 1000 slots |"
      "\n| --- | --- | --- | --- | --- |\n");
  const PolicyParams fixed = base("tocp_reverse");
  for (const Normal to : {Normal{68, 9}, Normal{60, 8}, Normal{90, 5}, thesis_good}) {
    for (const double correlation : {0.5, 0.9}) {
      print_drift("fixed", correlation, to, fixed);
      print_drift("apply", correlation, to, applying(fixed));
      std::fflush(stdout);
    }
  }
}

/// Half an hour that looks half good, in an hour of good: what is in force at its end.
void fault() {
  std::printf("\n| 30 min at | law in force after it | left out, %% |\n| --- | --- | --- |\n");
  for (const double mean : {20.0, 36.6, 50.0, 55.0, 60.0, 65.0}) {
    Trace trace = simulate({"good", 1e9, 1.1, thesis_good, thesis_bad, 0.5, 1}, 5400, 1);
    for (std::size_t n = 3600; n < trace.qni.size(); ++n) trace.qni[n] += mean - thesis_good.mean;
    const auto policy = make_policy(applying(base("tocp_reverse")));
    (void)decide(*policy, trace.qni);
    const LearnedLaw learned = policy->learned().value();
    std::printf("| %.1f | %s | %.0f |\n", mean, text_of(learned.in_force).c_str(),
                100 * learned.left_out_share);
  }
}

}  // namespace
}  // namespace tocsin::decision

int main(int argc, char** argv) {
  using namespace tocsin::decision;
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
  std::vector<Site> sites;
  for (int i = 2; i < argc; ++i) sites.push_back(recorded(argv[i]));
  const bool simulation = sites.empty();
  if (simulation) sites = simulated_sites();
  leave_one_out(sites, rounds);
  if (!simulation) return 0;
  drift();
  fault();
}
