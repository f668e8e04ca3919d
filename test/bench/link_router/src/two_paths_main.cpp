// SPDX-License-Identifier: Apache-2.0
// What a second path buys: the traffic of the thesis's missions, without a policy and with one
// queue a radio, over the thesis's radio, and over two. usage: two_paths [SEEDS [SECONDS [SHARE]]]
// SHARE: of the variance of shadowing that the second radio shares with the first. Mean of the
// seeds, with the half of its 95 % interval. *phi*: correlation of what either radio alone has late
// or lost.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "link_run.hpp"
#include "mission_traffic.hpp"
#include "radio_channel/channel_files.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

struct Mean {
  double mean = 0;
  double half = 0;  ///< of the 95 % interval
};
Mean mean_of(const std::vector<Figures>& runs, double Figures::*value) {
  const auto n = static_cast<double>(runs.size());
  double sum = 0;
  double squares = 0;
  for (const Figures& run : runs) sum += run.*value;
  for (const Figures& run : runs) squares += std::pow(run.*value - sum / n, 2);
  return {sum / n, n > 1 ? 1.96 * std::sqrt(squares / (n - 1) / n) : 0};
}

/// Sums for the correlation of two yes-or-no series (Pearson's phi).
class Phi {
 public:
  void add(const std::vector<bool>& one, const std::vector<bool>& other) {
    for (std::size_t i = 0; i < one.size() && i < other.size(); ++i) {
      ++all_;
      one_ += one[i] ? 1 : 0;
      other_ += other[i] ? 1 : 0;
      both_ += one[i] && other[i] ? 1 : 0;
    }
  }
  [[nodiscard]] double value() const {
    const double p = one_ / all_;
    const double q = other_ / all_;
    const double spread = std::sqrt(p * (1 - p) * q * (1 - q));
    return spread > 0 ? (both_ / all_ - p * q) / spread : 0;
  }

 private:
  double all_ = 0;
  double one_ = 0;
  double other_ = 0;
  double both_ = 0;
};

struct Row {
  std::string name;
  std::vector<Figures> runs = {};
};

void print(const char* mission, const Row& row, double one_kb_per_s) {
  const Mean late = mean_of(row.runs, &Figures::critical_late);
  const Mean high = mean_of(row.runs, &Figures::high_late);
  const Mean p99 = mean_of(row.runs, &Figures::critical_p99_ms);
  const Mean high_p99 = mean_of(row.runs, &Figures::high_p99_ms);
  const double low = mean_of(row.runs, &Figures::low_delivered).mean;
  const double air = mean_of(row.runs, &Figures::critical_kb_per_s).mean / one_kb_per_s;
  const Mean unplugged = mean_of(row.runs, &Figures::unplugged_late);
  std::printf(
      "%s  %-28s  %.3f +-%.3f  %.3f +-%.3f  %4.0f +-%2.0f  %4.0f +-%2.0f  %5.1f  %.2f  %.2f "
      "+-%.2f\n",
      mission, row.name.c_str(), late.mean, late.half, high.mean, high.half, p99.mean, p99.half,
      high_p99.mean, high_p99.half, low, air, unplugged.mean, unplugged.half);
}

/// Nothing passes from the middle of the mission on.
radio::ChannelParams unplugged(radio::ChannelParams params, const MissionTraffic& traffic) {
  const double length_s = to_seconds(traffic.end - traffic.begin);
  params.outages_s = {length_s / 2, length_s};
  return params;
}

/// The runs of one seed, a row each.
class SeedRuns {
 public:
  SeedRuns(const MissionTraffic& traffic, int seed)
      : traffic_(traffic), seed_(static_cast<std::uint64_t>(seed)) {}

  void run(double shared, const radio::ChannelParams& modem, std::vector<Row>& rows, Phi& phi) {
    rows_ = rows.begin();
    add();
    radio::ChannelParams other = traffic_.channel;
    other.shared_shadowing = shared;
    const auto alone = critical_misses(traffic_, steps_, seed_);
    steps_.first = other;
    phi.add(alone, critical_misses(traffic_, steps_, seed_));
    steps_.first.reset();
    steps_.second = other;
    for (const PathUse use : {PathUse::best, PathUse::repair, PathUse::both}) {
      steps_.urgent = use;
      add();
    }
    steps_.urgent = PathUse::repair;
    add_unplugged();
    steps_.second = modem;
    steps_.params.second_bytes_per_s = 125000;
    add();
    add_unplugged();
  }

 private:
  void add() { (rows_++)->runs.push_back(run_link(traffic_, steps_, seed_)); }
  void add_unplugged() {
    steps_.first = unplugged(traffic_.channel, traffic_);
    steps_.unplugged = traffic_.begin + (traffic_.end - traffic_.begin) / 2;
    add();
    steps_.first.reset();
    steps_.unplugged.reset();
  }
  const MissionTraffic& traffic_;
  const std::uint64_t seed_;
  Steps steps_;
  std::vector<Row>::iterator rows_;
};

void run_mission(bool b, int seeds, double duration_s, double shared) {
  std::vector<Row> rows{{"one path"},
                        {"two, best"},
                        {"two, repair"},
                        {"two, both while poor"},
                        {"two, repair, first unplugged"},
                        {"a modem, repair"},
                        {"a modem, first unplugged"}};
  Phi phi;
  const radio::ChannelParams modem = radio::load_channel(share() + "/config/radio/modem.yaml");
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto traffic = record_mission({b, false, "none", seed, duration_s});
    SeedRuns(traffic, seed).run(shared, modem, rows, phi);
  }
  const double one_kb_per_s = mean_of(rows[0].runs, &Figures::critical_kb_per_s).mean;
  for (const Row& row : rows) print(b ? "B" : "A", row, one_kb_per_s);
  std::printf("%s  phi %.2f\n", b ? "B" : "A", phi.value());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("two_paths", [&] {
    const int seeds = argc > 1 ? std::stoi(argv[1]) : 20;
    const double duration_s = argc > 2 ? std::stod(argv[2]) : 600;
    const double shared = argc > 3 ? std::stod(argv[3]) : 0.5;
    std::printf(
        "                                  critical late%%   high late%%      crit p99 ms "
        "high p99 ms  low%%  critical's air  late of the 2 s%%\n");
    for (const bool b : {false, true}) run_mission(b, seeds, duration_s, shared);
    return 0;
  });
}
