// SPDX-License-Identifier: Apache-2.0
#include "turns.hpp"

#include <cstdio>

namespace tocsin::bench {
namespace {

/// Round trips of one generation, by way.
using Trips = std::vector<Series>;

Trips take_turns(const Generation& generation, const Plan& plan) {
  const std::size_t count = generation.ways.size();
  Trips trips(count);
  for (int turn = 0; turn < plan.turns; ++turn) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t way = turn % 2 == 0 ? i : count - 1 - i;
      if (!generation.ways[way]->run(plan.trips, trips[way])) std::printf("way %zu: silent\n", way);
    }
  }
  return trips;
}

void print(const std::string& load, const std::vector<Title>& titles,
           const std::vector<Trips>& generations) {
  for (std::size_t way = 0; way < titles.size(); ++way) {
    Series all;
    std::vector<double> medians;
    std::vector<double> tails;
    for (const Trips& trips : generations) {
      const Series& rival = trips[titles[way].rival];
      all.add(trips[way]);
      medians.push_back(trips[way].percentile(0.5) / rival.percentile(0.5));
      tails.push_back(trips[way].percentile(0.99) / rival.percentile(0.99));
    }
    std::printf("%s  %-32s %s   median %s   p99 %s\n", load.c_str(), titles[way].name,
                all.text().c_str(), share_text(medians).c_str(), share_text(tails).c_str());
  }
  (void)std::fflush(stdout);
}

}  // namespace

void compare(const std::string& load, const std::vector<Title>& titles, const Plan& plan,
             const std::function<Generation()>& set_up) {
  std::vector<Trips> generations;
  for (int i = 0; i < plan.generations; ++i) generations.push_back(take_turns(set_up(), plan));
  print(load, titles, generations);
}

}  // namespace tocsin::bench
