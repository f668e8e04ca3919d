// SPDX-License-Identifier: Apache-2.0
// Policies against recorded decisions, sample by sample: the decision after sample n is column n.
#include <gtest/gtest.h>

#include <iostream>

#include "decision/policy.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

struct Column {
  const char* policy;
  const char* name;
  bool myopic = false;
};

void follow(const char* file, const Column& column) {
  const auto path = golden_file(file);
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table table = read_table(path);
  PolicyParams params;
  params.policy = value_of<PolicyKind>(column.policy).value();
  params.belief_myopic = column.myopic;
  params.th_max_s = 86400;  // the traces know samples only
  const auto sut = make_policy(params);
  Deviations decisions;
  Time now{};
  for (std::size_t n = 0; n < table.rows; ++n) {
    now += std::chrono::seconds(1);
    const Evidence evidence = sut->on_sample({now, table.columns["qni"][n]}, now);
    decisions.exact(evidence.state == State::active, table.columns[column.name][n] > 0.5);
  }
  std::cout << file << ' ' << column.name << ": " << decisions.summary() << '\n';
  EXPECT_EQ(decisions.compared(), 1500);
  EXPECT_EQ(decisions.outside(), 0);
}

class GoldenDecisions : public ::testing::TestWithParam<Column> {};

TEST_P(GoldenDecisions, AreReproducedOnTrace1) { follow("trace1_iid.csv", GetParam()); }
TEST_P(GoldenDecisions, AreReproducedOnTrace2) { follow("trace2_ar_ramp.csv", GetParam()); }

// The thesis's source pauses for up to 32 samples; its column pays for a forced slot at 30, too.
INSTANTIATE_TEST_SUITE_P(Policies, GoldenDecisions,
                         ::testing::Values(Column{"tocp", "tx_timer"}, Column{"tocp_dsp", "tx_dsp"},
                                           Column{"tocp_reverse", "tx_rev"},
                                           Column{"belief", "tx_bdp"},
                                           Column{"belief", "tx_hmm", true},
                                           Column{"legacy", "tx_legacy"}));

}  // namespace
}  // namespace tocsin::decision
