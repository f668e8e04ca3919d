// SPDX-License-Identifier: Apache-2.0
#include "turns.hpp"

#include <algorithm>
#include <cstdio>

namespace tocsin::bench {
namespace {

/// Round trips of one generation, by way.
using Trips = std::vector<Series>;

/// Each turn begins with the next way, so that none has the best place; `forwards` or backwards,
/// so that none has always the same before it.
Trips take_turns(const Generation& generation, const Plan& plan, bool forwards) {
  const std::size_t count = generation.ways.size();
  Trips trips(count);
  for (std::size_t turn = 0; turn < plan.rounds * count; ++turn) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = (turn + i) % count;
      const std::size_t way = forwards ? place : count - 1 - place;
      Series warm_up;  // what the way before has left behind: cold caches, answers under way
      Way& one = *generation.ways[way];
      if (!one.run(std::max(plan.trips / 10, 5), warm_up) || !one.run(plan.trips, trips[way])) {
        std::printf("way %zu: silent\n", way);
      }
    }
  }
  return trips;
}

/// The shares of a rival's median and 99th percentile.
std::string shares(const std::vector<Trips>& generations, std::size_t way, std::size_t rival) {
  std::vector<double> medians;
  std::vector<double> tails;
  for (const Trips& trips : generations) {
    medians.push_back(trips[way].percentile(0.5) / trips[rival].percentile(0.5));
    tails.push_back(trips[way].percentile(0.99) / trips[rival].percentile(0.99));
  }
  return "median " + share_text(medians) + "   p99 " + share_text(tails);
}

void print(const std::string& load, const std::vector<Title>& titles,
           const std::vector<Trips>& generations) {
  for (std::size_t way = 0; way < titles.size(); ++way) {
    Series all;
    for (const Trips& trips : generations) all.add(trips[way]);
    std::printf("%s  %-32s %s\n", load.c_str(), titles[way].name, all.text().c_str());
    for (const std::size_t rival : titles[way].rivals) {
      std::printf("%s    of %-29s %s\n", load.c_str(), titles[rival].name,
                  shares(generations, way, rival).c_str());
    }
  }
  (void)std::fflush(stdout);
}

}  // namespace

void compare(const std::string& load, const std::vector<Title>& titles, const Plan& plan,
             const std::function<Generation()>& set_up) {
  std::vector<Trips> generations;
  for (int i = 0; i < plan.generations; ++i) {
    generations.push_back(take_turns(set_up(), plan, i % 2 == 0));
  }
  print(load, titles, generations);
}

}  // namespace tocsin::bench
