// SPDX-License-Identifier: Apache-2.0
#include "turns.hpp"

#include <cstdio>

namespace tocsin::bench {
namespace {

/// Round trips of one block, by way.
using Block = std::vector<Series>;

Block take_turns(const Generation& generation, const Plan& plan) {
  const std::size_t count = generation.ways.size();
  Block block(count);
  for (int turn = 0; turn < plan.turns; ++turn) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t way = turn % 2 == 0 ? i : count - 1 - i;
      if (!generation.ways[way]->run(plan.trips, block[way])) std::printf("way %zu: silent\n", way);
    }
  }
  return block;
}

void print(const std::string& load, const std::vector<Title>& titles,
           const std::vector<Block>& blocks) {
  for (std::size_t way = 0; way < titles.size(); ++way) {
    Series all;
    std::vector<double> medians;
    std::vector<double> tails;
    for (const Block& block : blocks) {
      const Series& rival = block[titles[way].rival];
      all.add(block[way]);
      medians.push_back(block[way].percentile(0.5) / rival.percentile(0.5));
      tails.push_back(block[way].percentile(0.99) / rival.percentile(0.99));
    }
    std::printf("%s  %-32s %s   median %s   p99 %s\n", load.c_str(), titles[way].name,
                all.text().c_str(), share_text(medians).c_str(), share_text(tails).c_str());
  }
  (void)std::fflush(stdout);
}

}  // namespace

void compare(const std::string& load, const std::vector<Title>& titles, const Plan& plan,
             const std::function<Generation()>& set_up) {
  std::vector<Block> blocks;
  for (int i = 0; i < plan.generations; ++i) {
    const Generation generation = set_up();
    for (int j = 0; j < plan.blocks; ++j) blocks.push_back(take_turns(generation, plan));
  }
  print(load, titles, blocks);
}

}  // namespace tocsin::bench
