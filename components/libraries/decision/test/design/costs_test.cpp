// SPDX-License-Identifier: Apache-2.0
#include "decision/design/costs.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "decision/policy.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

using Bits = std::vector<bool>;

TEST(CostOf, AddsSlotsAndChanges) {
  const auto slots = slots_of({false, true, true, false}, {});
  EXPECT_DOUBLE_EQ(cost_of(slots, 0.5, Bits{true, true, true, true}), 2);
  EXPECT_DOUBLE_EQ(cost_of(slots, 0.5, Bits{true, false, false, true}), 0.2 + 1);
  EXPECT_DOUBLE_EQ(cost_of(slots, 0.5, Bits{false, false, false, false}), 1.2 + 0.5);
}

TEST(Clairvoyant, IsSilentExactlyInALongBadSpell) {
  const Clairvoyant sut = clairvoyant(slots_of({0, 1, 1, 1, 0, 0}, {}), 0.5, 30);
  EXPECT_EQ(sut.send, (Bits{1, 0, 0, 0, 1, 1}));
  EXPECT_DOUBLE_EQ(sut.cost, 1.3);
}

TEST(Clairvoyant, SpeaksThroughASpellTooShortToPay) {
  const Clairvoyant sut = clairvoyant(slots_of({0, 1, 0}, {}), 0.5, 30);
  EXPECT_EQ(sut.send, (Bits{1, 1, 1}));
  EXPECT_DOUBLE_EQ(sut.cost, 1);
}

TEST(Clairvoyant, SpeaksOnceWhenSilenceReachesItsLimit) {
  const Clairvoyant sut = clairvoyant(slots_of(Bits(9, true), {1, 0.5, 0, 0}), 0, 4);
  EXPECT_DOUBLE_EQ(sut.cost, 1);
  EXPECT_EQ(sut.send[4], true);
}

/// Every sequence of actions, for short traces.
double brute_force(const std::vector<Slot>& slots, double change, int th_max) {
  double best = 1e9;
  for (unsigned code = 0; code < 1U << slots.size(); ++code) {
    Bits send(slots.size());
    int run = 0;
    bool allowed = true;
    for (std::size_t n = 0; n < slots.size(); ++n) {
      send[n] = (code >> n & 1U) != 0;
      run = send[n] ? 0 : run + 1;
      allowed = allowed && run <= th_max;
    }
    if (allowed) best = std::min(best, cost_of(slots, change, send));
  }
  return best;
}

TEST(Clairvoyant, EqualsTheBestOfAllSequences) {
  std::mt19937 random(2);  // NOLINT: a fixed seed is the point
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Slot> slots;
    for (int n = 0; n < 10; ++n)
      slots.push_back({double(random() % 8) / 4, double(random() % 8) / 4});
    const Clairvoyant sut = clairvoyant(slots, 0.5, 3);
    EXPECT_NEAR(sut.cost, brute_force(slots, 0.5, 3), 1e-12);
    EXPECT_NEAR(cost_of(slots, 0.5, sut.send), sut.cost, 1e-12);
  }
}

TEST(Oracle, IsAPolicyThatDoesWhatTheClairvoyantDoes) {
  const Bits bad{0, 1, 1, 1, 0, 0};
  const auto sut = make_oracle(slots_of(bad, {}), 0.5, 30);
  Bits send{true};
  for (int n = 0; n < 5; ++n) {
    const Time now{std::chrono::seconds(n)};
    send.push_back(sut->on_sample({now, 50}, now).state == State::active);
  }
  EXPECT_EQ(send, (Bits{1, 0, 0, 0, 1, 1}));
}

/// Costs of the recorded decisions and of the clairvoyant, as summed up beside the golden traces.
void compare(const char* file, const char* key) {
  const auto path = golden_file(std::string(file) + ".csv");
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table t = read_table(path);
  const auto summary = nlohmann::json::parse(std::ifstream(golden_file("traces_summary.json")));
  Bits bad;
  Bits send;
  for (std::size_t n = 1; n < t.rows; ++n) {
    bad.push_back(t.columns["state"][n] > 0.5);
    send.push_back(t.columns[std::string("tx_") + key][n - 1] > 0.5);
  }
  const auto& want = summary[file]["policies"];
  EXPECT_NEAR(cost_of(slots_of(bad, {}), 0.5, send), double(want[key]["cost"]), 1e-9) << key;
  EXPECT_NEAR(clairvoyant(slots_of(bad, {}), 0.5, 30).cost, double(want["oracle_cost"]), 1e-9);
}

TEST(Costs, AgreeWithGoldenTrace1) {
  for (const char* key : {"timer", "dsp", "rev", "hmm", "bdp", "legacy"})
    compare("trace1_iid", key);
}
TEST(Costs, AgreeWithGoldenTrace2) {
  for (const char* key : {"timer", "dsp", "rev", "hmm", "bdp", "legacy"}) {
    compare("trace2_ar_ramp", key);
  }
}

}  // namespace
}  // namespace tocsin::decision
