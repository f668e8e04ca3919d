// SPDX-License-Identifier: Apache-2.0
#include "coverage/coverage_progress.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tocsin::coverage {
namespace {

/// The swaths in the order of the drive; each is blocked as often as it is in `blocked`.
std::vector<std::size_t> drive(CoverageProgress& sut, std::multiset<std::size_t> blocked) {
  std::vector<std::size_t> driven;
  while (const Stop* stop = sut.next()) {
    const auto found = blocked.find(stop->swath);
    if (found == blocked.end()) {
      driven.push_back(stop->swath);
      sut.on_reached();
    } else {
      blocked.erase(found);
      sut.on_blocked();
    }
  }
  return driven;
}

const std::vector<Stop> four{{{}, 0}, {{}, 1}, {{}, 2}, {{}, 3}};
using Order = std::vector<std::size_t>;

TEST(CoverageProgress, PassesOverWhatIsBlockedAndComesBackOnce) {
  CoverageProgress sut(four);
  EXPECT_EQ(drive(sut, {1, 2, 2}), (Order{0, 3, 1}));
  EXPECT_EQ(sut.given_up(), (Order{2}));
  EXPECT_EQ(sut.reached(), 3U);
}

TEST(CoverageProgress, EndsWhereEverythingIsBlockedOrThereIsNothing) {
  CoverageProgress sut(four);
  EXPECT_EQ(drive(sut, {0, 0, 1, 1, 2, 2, 3, 3}), Order{});
  EXPECT_EQ(sut.given_up().size(), 4U);
  EXPECT_EQ(CoverageProgress({}).next(), nullptr);
}

}  // namespace
}  // namespace tocsin::coverage
