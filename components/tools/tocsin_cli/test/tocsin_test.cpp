// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "foundation/temporary_folder.hpp"

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;

/// Runs `tocsin` with two toy verbs in $PATH, and no installed ones.
class TocsinTest : public ::testing::Test {
 protected:
  TocsinTest() {
    folder_.write_program("bin/tocsin-wave", "echo 'Wave a flag'; echo \"args $*\"");
    folder_.write_program("bin/tocsin-fail", "exit 7");
  }
  int run(const std::string& arguments) const {
    const std::string command = "PATH=" + folder_.path("bin") +
                                ":/usr/bin:/bin " TOCSIN_PROGRAM " " + arguments + " >" +
                                folder_.path("out") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] std::string output() const { return folder_.read("out"); }
  TemporaryFolder folder_;
};

TEST_F(TocsinTest, RunsTheProgramOfTheVerb) {
  EXPECT_EQ(run("wave --left 'two words'"), 0);
  EXPECT_THAT(output(), HasSubstr("args --left two words\n"));
}

TEST_F(TocsinTest, ReturnsTheExitCodeOfTheVerb) { EXPECT_EQ(run("fail"), 7); }

TEST_F(TocsinTest, ListsVerbsWithTheirDescriptions) {
  EXPECT_EQ(run("--help"), 0);
  EXPECT_THAT(output(), HasSubstr("  wave         Wave a flag\n"));
}

TEST_F(TocsinTest, SuggestsAVerbForAnUnknownOne) {
  EXPECT_EQ(run("wafe"), 2);
  EXPECT_EQ(output(), "tocsin: 'wafe' is not a verb; did you mean 'wave'?\n");
}

TEST_F(TocsinTest, ListsTheVerbsWhenNoneIsNear) {
  EXPECT_EQ(run("xyzzyxyzzy"), 2);
  EXPECT_THAT(output(), HasSubstr("is not a verb; the verbs are: fail, wave"));
}

TEST_F(TocsinTest, TellsWhatBuildsAShippedVerbThatIsNotBuilt) {
  EXPECT_EQ(run("sim mission.yaml"), 1);
  EXPECT_EQ(output(),
            "tocsin: 'sim' is not here; bringup/build run builds it, package tocsin-sim has it\n");
  EXPECT_EQ(run("archive"), 1);
  EXPECT_THAT(output(), HasSubstr("package tocsin-archive has it"));
}

TEST_F(TocsinTest, TellsTheVersionOfItsPackage) {
  std::ifstream package(TOCSIN_SOURCE_DIR "/package.xml");
  const std::string text{std::istreambuf_iterator<char>(package), {}};
  EXPECT_EQ(run("--version"), 0);
  ASSERT_THAT(output(),
              ::testing::MatchesRegex("tocsin [0-9]+\\.[0-9]+\\.[0-9]+ "
                                      "\\(commit ([0-9a-f]+|unknown), Fast DDS [0-9.]+\\)\n"));
  const std::string version = output().substr(7, output().find(" (") - 7);
  EXPECT_THAT(text, HasSubstr("<version>" + version + "</version>"));
}

TEST_F(TocsinTest, AsksForAVerb) {
  EXPECT_EQ(run(""), 2);
  EXPECT_THAT(output(), HasSubstr("a verb is missing"));
}

}  // namespace
}  // namespace tocsin::cli
