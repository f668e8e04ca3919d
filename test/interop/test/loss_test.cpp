// SPDX-License-Identifier: Apache-2.0
// Reliable samples between ours and participants of other vendors that lose packets in both
// directions, announcements included.
#include <gtest/gtest.h>

#include <list>

#include "peer_process.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::seconds;

/// Fast DDS repairs with its default settings each 3 s, and 30 % of that is lost, too.
constexpr seconds patience{120};
/// In a row, at 20 a second: without repairs one in 10^6 runs at 30 % loss.
constexpr std::size_t enough = 40;

/// On a domain of their own; `theirs` loses so many of 100 packets each way.
struct LossyPair {
  LossyPair(const std::string& maker, int loss_percent, int domain)
      : ours("tocsin", domain, "ours"),
        theirs(PeerOptions{maker, domain, maker, 0, loss_percent}),
        name(maker + " with " + std::to_string(loss_percent) + " % loss") {}
  PeerProcess ours;
  PeerProcess theirs;
  std::string name;
};

TEST(Loss, EveryReliableSampleComesInBothDirections) {
  std::list<LossyPair> pairs;  // all at the same time
  int domain = 150;
  for (const char* const maker : {"cyclone", "fast_dds"}) {
    for (const int loss_percent : {5, 30}) pairs.emplace_back(maker, loss_percent, domain++);
  }
  for (const LossyPair& one : pairs) {
    EXPECT_TRUE(within(patience, [&] { return one.ours.heard_in_a_row(one.theirs) >= enough; }))
        << "ours heard " << one.ours.heard_in_a_row(one.theirs) << " of " << one.name;
    EXPECT_TRUE(within(patience, [&] { return one.theirs.heard_in_a_row(one.ours) >= enough; }))
        << one.name << " heard " << one.theirs.heard_in_a_row(one.ours) << " of ours";
  }
}

}  // namespace
}  // namespace tocsin::interop
