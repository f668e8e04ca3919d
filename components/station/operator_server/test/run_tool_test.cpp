// SPDX-License-Identifier: Apache-2.0
#include "run_tool.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "foundation/temporary_folder.hpp"

namespace tocsin::foxglove {
namespace {

using End = ToolOutcome::End;
using ::testing::HasSubstr;

class RunToolTest : public ::testing::Test {
 protected:
  [[nodiscard]] ToolOutcome run(const std::string& script, const ToolLimits& limits = {}) const {
    return run_tool({folder_.write_program("tool", script), "one", "two words"}, limits,
                    cancelled_);
  }
  const TemporaryFolder folder_;
  std::atomic<bool> cancelled_{false};
};

TEST_F(RunToolTest, GivesWhatItPrintsAndHowItEnds) {
  const ToolOutcome good = run("echo \"$1,$2\"");
  EXPECT_EQ(good.end, End::success);
  EXPECT_EQ(good.printed, "one,two words\n");
  const ToolOutcome bad = run("echo wrong >&2; exit 2");
  EXPECT_EQ(bad.end, End::failure);
  EXPECT_EQ(bad.printed, "wrong\n");
}

TEST_F(RunToolTest, AProgramThatIsNotThereFails) {
  const ToolOutcome outcome = run_tool({"/no/such/program"}, {}, cancelled_);
  EXPECT_EQ(outcome.end, End::failure);
  EXPECT_THAT(outcome.printed, HasSubstr("No such file"));
}

TEST_F(RunToolTest, WhatTakesTooLongIsEnded) {
  EXPECT_EQ(run("sleep 600", {std::chrono::milliseconds(200)}).end, End::too_long);
}

TEST_F(RunToolTest, WhatPrintsTooMuchIsEnded) {
  const ToolOutcome outcome =
      run("while :; do echo and so on; done", {std::chrono::minutes(1), 100'000});
  EXPECT_EQ(outcome.end, End::too_much);
}

TEST_F(RunToolTest, IsEndedWhenItIsNotWantedAnyMore) {
  ToolOutcome outcome;
  std::thread runs([&] { outcome = run("sleep 600"); });
  cancelled_ = true;
  runs.join();
  EXPECT_EQ(outcome.end, End::cancelled);
}

}  // namespace
}  // namespace tocsin::foxglove
