// SPDX-License-Identifier: Apache-2.0
#include "event_queue.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tocsin::simulation {
namespace {

constexpr Time second{std::chrono::seconds(1)};
constexpr Time third{std::chrono::seconds(2)};

TEST(EventQueue, RunsInTheOrderOfTimeAndOfAsking) {
  std::string order;
  EventQueue sut;
  sut.at(third, [&] { order += 'z'; });
  for (char c = 'a'; c <= 'h'; ++c) sut.at(second, [&order, c] { order += c; });
  sut.run(third);
  EXPECT_EQ(order, "abcdefghz");
}

TEST(EventQueue, KeepsWhatIsDueLater) {
  int runs = 0;
  EventQueue sut;
  sut.at(third, [&] { ++runs; });
  sut.run(third - Duration{1});
  EXPECT_EQ(runs, 0);
  EXPECT_EQ(sut.next(), third);
  sut.run(third);
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(sut.next(), never);
}

TEST(EventQueue, RunsWhatAnEventAddsForTheSameInstant) {
  int runs = 0;
  EventQueue sut;
  sut.at(second, [&] { sut.at(second, [&] { ++runs; }); });
  sut.run(second);
  EXPECT_EQ(runs, 1);
}

}  // namespace
}  // namespace tocsin::simulation
