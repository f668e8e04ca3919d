// SPDX-License-Identifier: Apache-2.0
#include "command_line/run_to_end.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

Ended shell(const std::string& text) { return run_to_end({"/bin/sh", "-c", text}); }

TEST(RunToEnd, GivesTheExitCodeAndBothOutputsInOrder) {
  const Ended ended = shell("echo one; echo two >&2; echo three; exit 3");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.output, "one\ntwo\nthree\n");
}

TEST(RunToEnd, AProgramThatDiesByASignalIsToldFromOneThatEnds) {
  EXPECT_EQ(shell("kill -9 $$").code, 128 + 9);
}

TEST(RunToEnd, TheProgramHasNoInput) { EXPECT_EQ(shell("cat; echo end").output, "end\n"); }

TEST(RunToEnd, TakesMoreThanAPipeHolds) {
  EXPECT_EQ(shell("head -c 1000000 /dev/zero").output.size(), 1000000U);
}

TEST(RunToEnd, AProgramThatIsNotThereIsAnEnvironmentError) {
  EXPECT_THROW((void)run_to_end({"/nowhere/program"}), EnvironmentError);
}

TEST(RunToEnd, GivesItsInputHoweverLong) {
  const std::string text(1000000, 'x');
  EXPECT_EQ(run_to_end({"cat"}, {text, ""}).output, text);
  EXPECT_EQ(run_to_end({"cat"}).output, "");
}

TEST(RunToEnd, RunsInAFolderWhoseNameNeedsQuotes) {
  const TemporaryFolder folder;
  (void)folder.write("it's $here/file", "");
  EXPECT_EQ(run_to_end({"ls"}, {"", folder.path("it's $here")}).output, "file\n");
  EXPECT_THROW((void)run_to_end({"ls"}, {"", folder.path("nowhere")}), EnvironmentError);
}

}  // namespace
}  // namespace tocsin
