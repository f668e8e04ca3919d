// SPDX-License-Identifier: Apache-2.0
// `tocsin qos tune` with a program in place of `tocsin experiment`, which stands beside it: what it
// is told, and what is made of what it answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::qos_tool {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Answers with a cost for each candidate: lifespan 0.5 is the better one. Its words go to a file.
const char* const experiment =
    "#!/bin/sh\n"
    "echo \"$@\" >> \"$(dirname \"$0\")/told\"\n"
    "out=$4\n"
    "mkdir -p \"$out\"\n"
    "[ -e \"$(dirname \"$0\")/broken\" ] && exit 3\n"
    "table=$out/runs.csv\n"
    "echo mission,channel,payload,policy,index,failure,user_cost,critical_late,high_late,"
    "low_delivered,location_age_p99,picture_latency_p99 > \"$table\"\n"
    "for seed in 1 2 3; do\n"
    "  echo \"b,near,camera,shipped,$seed,,1$seed,1,1,90,0.3,150\"\n"
    "  echo \"b,near,camera,c1,$seed,,$seed,1,1,90,0.3,150\"\n"
    "  echo \"b,near,camera,c2,$seed,,2$seed,1,1,90,0.3,150\"\n"
    "done >> \"$table\"\n";

const char* const tune_file =
    "missions:\n  - {name: b, file: b.yaml}\n"
    "channels:\n  - {name: near, file: near.yaml}\n"
    "payloads:\n  - {name: camera, camera: true}\n"
    "seeds: 3\n"
    "sweep:\n  qos.stream.lifespan_s: [0.5, 4]\n";

/// An installation of two programs, tocsin-qos and that one.
class RunTuneTest : public ::testing::Test {
 protected:
  RunTuneTest() {
    fs::create_directories(folder_.path("bin"));
    fs::create_directories(folder_.path("share/tocsin"));
    fs::create_directory_symlink(TOCSIN_REPOSITORY "/config", folder_.path("share/tocsin/config"));
    fs::copy_file(QOS_PROGRAM, folder_.path("bin/tocsin-qos"));
    const std::string program = folder_.write("bin/tocsin-experiment", experiment);
    fs::permissions(program, fs::perms::owner_all);
  }
  Ended tune(const std::string& text, std::vector<std::string> more = {}) {
    const std::string file = folder_.write("try.yaml", text);
    std::vector<std::string> words{"/usr/bin/env",
                                   "PATH=/usr/bin:/bin",  // no other experiment
                                   folder_.path("bin/tocsin-qos"),
                                   "tune",
                                   file,
                                   "--out",
                                   folder_.path("out")};
    words.insert(words.end(), more.begin(), more.end());
    return run_to_end(words);
  }
  std::string read(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(folder_.path(name)).rdbuf();
    return text.str();
  }
  TemporaryFolder folder_;
};

TEST_F(RunTuneTest, PlaysTheCandidatesAndRanksThem) {
  const Ended sut = tune(tune_file, {"--jobs", "2"});
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, AllOf(HasSubstr("less than what is shipped by 10.00"),
                                HasSubstr("qos.stream.lifespan_s=0.5 (better)"),
                                HasSubstr("qos.stream.lifespan_s=4 (worse)")));
  EXPECT_EQ(read("bin/told"), "run " + folder_.path("out/simulated.yaml") + " --out " +
                                  folder_.path("out/simulated") + " --jobs 2\n");
  EXPECT_THAT(read("out/simulated.yaml"), HasSubstr("c2.qos.yaml"));
  EXPECT_THAT(read("out/c1.qos.yaml"), HasSubstr("lifespan_s: 0.5"));
}

TEST_F(RunTuneTest, EndsWithTheCodeOfTheExperiment) {
  folder_.write("bin/broken", "");
  const Ended sut = tune(tune_file);
  EXPECT_EQ(sut.code, 3);
  EXPECT_THAT(sut.output, Not(HasSubstr("what users feel")));
}

TEST_F(RunTuneTest, RefusesAWrongFileInOneLineBeforeAnythingRuns) {
  const Ended sut = tune("sweep: {}\n");
  EXPECT_EQ(sut.code, 2);
  EXPECT_THAT(sut.output, HasSubstr("tocsin qos: sweep: is no map of settings"));
  EXPECT_FALSE(fs::exists(folder_.path("bin/told")));
}

TEST_F(RunTuneTest, SaysWhenThereIsNoExperimentProgram) {
  fs::remove(folder_.path("bin/tocsin-experiment"));
  const Ended sut = tune(tune_file);
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, HasSubstr("tocsin-experiment is not installed"));
}

}  // namespace
}  // namespace tocsin::qos_tool
