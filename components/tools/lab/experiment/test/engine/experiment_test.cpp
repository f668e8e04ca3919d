// SPDX-License-Identifier: Apache-2.0
// The installed program on a slice of the thesis's experiment, and on everything that can go wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include "engine/program.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const Slice two;

Slice of(const std::string& policies) { return {policies}; }
Slice of(int seeds) {
  Slice slice;
  slice.seeds = seeds;
  return slice;
}

TEST_F(ExperimentTest, RunsTheComponentsOfTheVehicleAndReports) {
  const Ended sut = run(of(2), "out");
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, AllOf(HasSubstr("4 of 4 runs"), HasSubstr("times real time")));
  const auto rows = table("out/runs.csv");
  ASSERT_EQ(rows.rows(), 4U);
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(rows.text(row, "failure"), "");
    EXPECT_EQ(rows.number(row, "seconds"), 40);
    EXPECT_GT(rows.number(row, "qni_mean"), 30);
    EXPECT_GT(rows.number(row, "high_delivered"), 50);
  }
  EXPECT_EQ(rows.text(0, "seed"), rows.text(2, "seed"));
  const Ended report = call("report " + folder_.path("out"));
  EXPECT_EQ(report.code, 0) << report.output;
  EXPECT_GT(fs::file_size(folder_.path("out/report.html")), 10000U);
}

TEST_F(ExperimentTest, GivesTheSameBytesAgain) {
  ASSERT_EQ(run(of(2), "one").code, 0);
  ASSERT_EQ(run(of(2), "other").code, 0);
  EXPECT_EQ(folder_.read("one/runs.csv"), folder_.read("other/runs.csv"));
  EXPECT_EQ(folder_.read("one/settings.yaml"), folder_.read("other/settings.yaml"));
  int files = 0;
  for (const auto& file : fs::directory_iterator(folder_.path("one/series"))) {
    const std::string name = "series/" + file.path().filename().string();
    EXPECT_EQ(folder_.read("one/" + name), folder_.read("other/" + name)) << name;
    ++files;
  }
  EXPECT_EQ(files, 4);
}

TEST_F(ExperimentTest, PlaysARunOfTwoSetsOnce) {
  const std::string file = folder_.write(
      "experiment.yaml", text_of(two) + "  - {name: again, policies: [none], seeds: 1}\n");
  const Ended sut = call("run " + file + " --jobs 2 --out " + folder_.path("out"));
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, HasSubstr("\n2 runs, 80 s simulated"));
  const auto rows = table("out/runs.csv");
  ASSERT_EQ(rows.rows(), 3U);
  EXPECT_EQ(rows.text(2, "set"), "again");
  EXPECT_EQ(rows.text(2, "qni_mean"), rows.text(0, "qni_mean"));
}

TEST_F(ExperimentTest, GoesOnAfterCtrlC) {
  const std::string file = folder_.write("experiment.yaml", text_of(of(40)));
  const std::string out = folder_.path("out");
  const pid_t child = ::fork();
  if (child == 0) {
    (void)!std::freopen(folder_.path("log").c_str(), "w", stdout);
    ::execl(program().c_str(), "tocsin-experiment", "run", file.c_str(), "--jobs", "2", "--out",
            out.c_str(), nullptr);
    ::_exit(127);
  }
  // Two workers: the third series is that of a run which was given out after a result had come.
  const auto series = [&] {
    std::error_code absent;
    return std::distance(fs::directory_iterator(out + "/series", absent), {});
  };
  while (series() < 3) ::usleep(1000);
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(folder_.read("log"), HasSubstr("the same command goes on"));
  const std::size_t kept = table("out/runs.csv").rows();
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, 80U);
  const Ended sut = call("run " + file + " --jobs 2 --out " + out);
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, HasSubstr(std::to_string(kept) + " of 80 runs are there already"));
  EXPECT_EQ(table("out/runs.csv").rows(), 80U);
}

TEST_F(ExperimentTest, NotesAPolicyThatThrowsAndFinishesTheOthers) {
  const Ended sut = run(
      of(two.policies + "  - {name: broken, policy: tocp, set: [false_alarm_samples=2]}\n"), "out");
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output,
              AllOf(HasSubstr("1 runs failed"), HasSubstr("main.a.thesis.plain.broken.1")));
  const auto rows = table("out/runs.csv");
  ASSERT_EQ(rows.rows(), 3U);
  EXPECT_EQ(rows.text(0, "failure"), "");
  EXPECT_NE(rows.text(2, "failure"), "");
}

TEST_F(ExperimentTest, SaysOnceThatTheDiskIsFull) {
  // Files of at most 1 KiB: settings.yaml does not fit.
  const Ended sut = run(of(2), "out", "ulimit -f 1; trap '' XFSZ;");
  EXPECT_EQ(sut.code, 1) << sut.output;
  EXPECT_THAT(sut.output, HasSubstr("cannot be written"));
}

TEST_F(ExperimentTest, KeepsWhatIsFinishedOnAFullDiskAndGoesOnWhenThereIsRoom) {
  if (!succeeds("unshare -m true")) GTEST_SKIP() << "no mount namespace is permitted here";
  const std::string file = folder_.write("experiment.yaml", text_of(of(20)));
  const std::string out = folder_.path("disk");
  const std::string sut = program() + " run " + file + " --jobs 2 --out " + out;
  const Ended ended = call_shell(
      "exec unshare -m sh " +
          folder_.write("inside",
                        "mkdir " + out + "\nmount -t tmpfs -o size=96k none " + out + "\n" + sut +
                            "\necho first $?\n"
                            "mount -o remount,size=8M " +
                            out + "\n" + sut + "\necho second $?\nwc -l <" + out + "/runs.csv\n"),
      folder_);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("No space left on device; finished runs are kept"),
                                  HasSubstr("first 1\n"), HasSubstr("of 40 runs are there already"),
                                  HasSubstr("second 0\n41\n")));
}

TEST_F(ExperimentTest, ReplaysTheTraceThatIsShipped) {
  Slice slice;
  slice.channel = config("radio/replay.yaml");
  const Ended sut = run(slice, "out");
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_GT(table("out/runs.csv").number(0, "qni_mean"), 30);
}

TEST_F(ExperimentTest, ReplaysMeasuredLinks) {
  const char* given = std::getenv("TOCSIN_SHARED");
  const std::string shared = given != nullptr ? given : config("../../shared");
  if (!fs::exists(shared + "/data/traces")) GTEST_SKIP() << "no measured traces on this machine";
  for (const char* name : {"external_robot_2G", "internal_client_2G_trial1",
                           "internal_server_5G_trial2short", "router_5G_trial2"}) {
    Slice slice;
    slice.channel =
        folder_.write("channel.yaml", "radio_channel:\n  noise_dbm: -91\n  trace_file: " + shared +
                                          "/data/traces/" + name + ".csv\n");
    const Ended sut = run(slice, name);
    EXPECT_EQ(sut.code, 0) << name << "\n" << sut.output;
    EXPECT_GT(table(std::string(name) + "/runs.csv").number(0, "qni_mean"), 0) << name;
  }
}

TEST_F(ExperimentTest, FitsParametersThatItsRunsThenUse) {
  // Two ways of being poor within 60 s: the limit is set where half of the way lies below.
  Slice slice;
  slice.kind = "fit";
  slice.seeds = 4;
  slice.policies = "  - {name: none}\n";
  slice.duration_s = 60;
  const std::string text = "fitted: fitted.yaml\npoor_below_snr_db: 17\n" + text_of(slice);
  const std::string file = folder_.write("experiment.yaml", text);
  EXPECT_THAT(call("run " + file).output, HasSubstr("`tocsin experiment fit"));
  const Ended sut = call("fit " + file + " --jobs 2 --out " + folder_.path("fit"));
  ASSERT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, AllOf(HasSubstr("mission a, 4 runs"), HasSubstr("pause_below_qni=")));
  folder_.write("experiment.yaml", with(text, "kind: fit", "kind: thesis"));
  const Ended used = call("run " + file + " --jobs 2 --out " + folder_.path("out"));
  EXPECT_EQ(used.code, 0) << used.output;
  EXPECT_THAT(folder_.read("out/settings.yaml"), HasSubstr("every_policy: [good_mean="));
}

TEST_F(ExperimentTest, RefusesWhatIsWrongBeforeTheFirstRun) {
  const Ended key = run(of("  - {name: tocp, set: [alfa=3]}\n"), "out");
  EXPECT_EQ(key.code, 2);
  EXPECT_THAT(key.output, AllOf(HasSubstr("alfa"), HasSubstr("tocp")));
  const Ended range = run(of("  - {name: tocp, set: [alpha=-3]}\n"), "out");
  EXPECT_EQ(range.code, 2);
  EXPECT_THAT(range.output, HasSubstr("alpha: -3 is outside"));
  const Ended policy = run(of("  - {name: luck}\n"), "out");
  EXPECT_EQ(policy.code, 2);
  EXPECT_THAT(policy.output, HasSubstr("luck"));
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(ExperimentTest, DoesNotMixTwoExperiments) {
  ASSERT_EQ(run(two, "out").code, 0);
  const Ended sut = run(of(2), "out");
  EXPECT_EQ(sut.code, 2);
  EXPECT_THAT(sut.output, HasSubstr("other settings"));
}

TEST_F(ExperimentTest, SaysWhatItCannotFitTo) {
  const std::string plain = folder_.write("plain.yaml", text_of(two));
  const Ended nowhere = call("fit " + plain + " --out " + folder_.path("fit"));
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.output, HasSubstr("experiment.fitted: names no file to write to"));
  const std::string text = "fitted: fitted.yaml\n" + text_of(two);
  const Ended none =
      call("fit " + folder_.write("none.yaml", text) + " --out " + folder_.path("n"));
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.output, HasSubstr("none is for this command"));
  Slice slice;
  slice.kind = "fit";
  const std::string policy = "fitted: fitted.yaml\n" + text_of(slice);
  const Ended sut =
      call("fit " + folder_.write("policy.yaml", policy) + " --out " + folder_.path("p"));
  EXPECT_EQ(sut.code, 2);
  EXPECT_THAT(sut.output, HasSubstr("fitted to runs without a policy"));
}

TEST_F(ExperimentTest, RefusesABadCommandLine) {
  EXPECT_EQ(call("run").code, 2);
  EXPECT_EQ(call("run /nonexistent.yaml").code, 2);
  EXPECT_EQ(call("report /tmp").code, 2);
  EXPECT_EQ(call("dance").code, 2);
}

}  // namespace
}  // namespace tocsin::experiment
