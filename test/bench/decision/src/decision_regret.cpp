// SPDX-License-Identifier: Apache-2.0
// Regret of each policy against the clairvoyant on the five scenarios, per 1000 slots.
// usage: decision_regret [SEEDS [SLOTS [COSTS]]]   COSTS is 1 (default) or 2
//
// COSTS 1: send in bad 1, silent in good .5, silent in bad .1, change .5.
// COSTS 2: send in bad 1, silent in good 1, else 0.
// "reference" is the project's earlier computation with its own program (20 seeds of 200 000 slots,
// first costs); z is the difference in joint standard errors. Exit code 1 when a target is missed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "decision/design/scenario.hpp"

namespace tocsin::decision {
namespace {

struct Entry {
  std::string name;
  PolicyParams params;
  double reference[5];  // 0 when there is none
  double error[5];
};

PolicyParams with(const std::string& policy) {
  PolicyParams params;
  params.policy = value_of<PolicyKind>(policy).value();
  params.th_max_s = 86400;  // the scenarios know samples only
  return params;
}

Entry threshold(const char* name, double low, double high, int in_a_row) {
  Entry entry{name, with("threshold"), {}, {}};
  entry.params.pause_below_qni = low;
  entry.params.resume_at_qni = high;
  entry.params.threshold_in_a_row = in_a_row;
  return entry;
}

Entry dsp(const char* name, double beta) {
  Entry entry{name, with("tocp_dsp"), {}, {}};
  entry.params.discount_value = beta;
  return entry;
}

Entry refer(Entry entry, std::vector<double> reference, std::vector<double> error) {
  std::copy(reference.begin(), reference.end(), entry.reference);
  std::copy(error.begin(), error.end(), entry.error);
  return entry;
}

/// Ratios clipped at 4 nats; at this alpha two bad samples are needed.
Entry clipped(const char* name, const char* policy) {
  Entry entry{name, with(policy), {}, {}};
  entry.params.llr_clip = 4;
  entry.params.alpha = 6.9;
  return entry;
}

Entry clipped_belief() {
  Entry entry{"belief clip 4", with("belief"), {}, {}};
  entry.params.llr_clip = 4;
  return entry;
}

Entry myopic() {
  Entry entry{"belief myopic", with("belief"), {}, {}};
  entry.params.belief_myopic = true;
  return entry;
}

std::vector<Entry> entries() {
  return {
      refer({"none", with("none"), {}, {}}, {118.51, 280.86, 54.21, 118.09, 117.08},
            {.88, 1.52, .22, .69, .95}),
      threshold("threshold 40/50", 40, 50, 1),
      refer(threshold("threshold 45/45", 45, 45, 1), {36.43, 66.72, 33.17, 119.19, 60.54},
            {.22, .35, .12, .70, .40}),
      refer(threshold("threshold 50/65 x2", 50, 65, 2), {19.84, 15.83, 35.34, 114.23, 59.93},
            {.10, .08, .10, .69, .31}),
      refer({"legacy", with("legacy"), {}, {}}, {157.70, 126.50, 217.52, 421.01, 136.23},
            {.51, .54, .40, .40, .46}),
      refer({"tocp", with("tocp"), {}, {}}, {68.69, 48.89, 148.43, 84.27, 88.39},
            {.29, .36, .37, .33, .46}),
      refer(dsp("tocp_dsp 1", 1), {45.50, 36.33, 111.36, 69.75, 66.14}, {.20, .24, .36, .33, .36}),
      refer(dsp("tocp_dsp .95", 0.95), {37.03, 39.01, 80.42, 65.87, 59.51},
            {.21, .22, .29, .28, .31}),
      refer(dsp("tocp_dsp .8", 0.8), {41.94, 68.38, 50.80, 75.96, 61.41},
            {.23, .42, .22, .34, .39}),
      refer({"tocp_reverse", with("tocp_reverse"), {}, {}}, {11.24, 9.26, 23.24, 44.21, 51.80},
            {.05, .04, .06, .21, .28}),
      clipped("tocp_reverse clip 4", "tocp_reverse"),
      clipped("tocp_dsp .95 clip 4", "tocp_dsp"),
      clipped_belief(),
      refer(myopic(), {11.26, 8.67, 23.60, 42.95, 50.91}, {.05, .04, .07, .17, .26}),
      refer({"belief", with("belief"), {}, {}}, {11.08, 8.51, 23.20, 39.26, 51.55},
            {.05, .04, .06, .16, .27}),
  };
}

double student(int seeds) {  // two-sided 95 %
  const double table[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26};
  const int freedom = seeds - 1;
  if (freedom < 1) return 0;
  return freedom <= 9 ? table[freedom - 1] : 1.96 + 2.5 / freedom;
}

std::vector<PolicyParams> fitted(const std::vector<Entry>& all, const Scenario& scenario,
                                 const SlotCosts& costs) {
  std::vector<PolicyParams> policies;
  for (const Entry& entry : all) {
    PolicyParams params = fitted_to(scenario, entry.params);
    params.cost_send_bad = costs.send_bad;
    params.cost_silent_good = costs.silent_good;
    params.cost_silent_bad = costs.silent_bad;
    params.cost_change = costs.change;
    policies.push_back(params);
  }
  return policies;
}

struct Row {
  std::string name;
  Estimate regret[5];
};

void print(const Entry& entry, const Row& row, bool first_costs, double t) {
  std::printf("%-20s", row.name.c_str());
  for (int s = 0; s < 5; ++s) {
    std::printf(" %7.2f +-%5.2f", row.regret[s].mean, t * row.regret[s].standard_error);
    if (!first_costs || entry.error[s] == 0) {
      std::printf("        ");
      continue;
    }
    const double joint = std::hypot(entry.error[s], row.regret[s].standard_error);
    std::printf(" z%+5.1f ", (row.regret[s].mean - entry.reference[s]) / joint);
  }
  std::printf("\n");
}

const Row& find(const std::vector<Row>& rows, const std::string& name) {
  return *std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
}

bool target(const char* text, double value, double limit) {
  std::printf("%-52s %6.3f  at most %5.2f  %s\n", text, value, limit,
              value <= limit ? "met" : "MISSED");
  return value <= limit;
}

bool targets(const std::vector<Row>& rows) {
  bool good = true;
  for (const char* name : {"belief", "tocp_reverse"}) {
    for (int s = 0; s < 3; ++s) {
      const double regret = find(rows, name).regret[s].mean;
      const std::string text = std::string(name) + " on S" + std::to_string(s + 1) + " over ";
      good &= target((text + "belief").c_str(), regret / find(rows, "belief").regret[s].mean, 1.10);
      good &= target((text + "tocp_dsp .95").c_str(),
                     regret / find(rows, "tocp_dsp .95").regret[s].mean, 0.35);
    }
    good &=
        target((std::string(name) + " on S5 over tocp_dsp .95").c_str(),
               find(rows, name).regret[4].mean / find(rows, "tocp_dsp .95").regret[4].mean, 0.90);
  }
  return good;
}

/// What bad samples do: the case for clipping.
void print_glitches(const std::vector<Entry>& all, const Campaign& campaign) {
  std::printf("\n%-20s", "policy");
  std::vector<std::vector<std::vector<double>>> regret;
  for (const Scenario& scenario : glitch_scenarios()) {
    std::printf(" %-18s", scenario.name);
    regret.push_back(regrets(scenario, fitted(all, scenario, campaign.costs), campaign));
  }
  std::printf("\n");
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::printf("%-20s", all[i].name.c_str());
    for (const auto& one : regret) {
      const Estimate e = estimate(one[i]);
      std::printf(" %7.2f +-%5.2f    ", e.mean, student(campaign.seeds) * e.standard_error);
    }
    std::printf("\n");
  }
  std::printf("\n");
}

int run(const Campaign& campaign, bool first_costs) {
  const std::vector<Entry> all = entries();
  std::vector<Row> rows(all.size());
  for (std::size_t s = 0; s < 5; ++s) {
    const Scenario& scenario = standard_scenarios()[s];
    const auto regret = regrets(scenario, fitted(all, scenario, campaign.costs), campaign);
    for (std::size_t i = 0; i < all.size(); ++i) {
      rows[i].name = all[i].name;
      rows[i].regret[s] = estimate(regret[i]);
    }
  }
  std::printf(
      "%d seeds of %d slots; regret per 1000 slots +- half width of the 95 %% interval, z\n",
      campaign.seeds, campaign.slots);
  std::printf("%-20s %-24s%-24s%-24s%-24s%-24s\n", "policy", " S1 G120/B20", " S2 G120/B60",
              " S3 G60/B5", " S4 f1=N(65,12)", " S5 AR .8 + ramps");
  for (std::size_t i = 0; i < all.size(); ++i) {
    print(all[i], rows[i], first_costs, student(campaign.seeds));
  }
  print_glitches(all, campaign);
  return !first_costs || targets(rows) ? 0 : 1;
}

}  // namespace
}  // namespace tocsin::decision

int main(int argc, char** argv) {
  tocsin::decision::Campaign campaign;
  if (argc > 1) campaign.seeds = std::max(1, std::atoi(argv[1]));
  if (argc > 2) campaign.slots = std::max(100, std::atoi(argv[2]));
  const bool first_costs = argc <= 3 || std::string(argv[3]) == "1";
  if (!first_costs) campaign.costs = {1, 1, 0, 0};
  return tocsin::decision::run(campaign, first_costs);
}
