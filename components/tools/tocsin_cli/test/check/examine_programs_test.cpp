// SPDX-License-Identifier: Apache-2.0
#include "examine_programs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExamineProgramsTest : public ::testing::Test {
 protected:
  ExamineProgramsTest() {
    for (const char* name : {"tocsin-container", "robot", "link_emulator", "kobuki_simulator"}) {
      (void)folder_.write_program(name, "echo \"$@\" >>" + folder_.path("asked") + "\n");
    }
    deployment_.run_dir = "/run";
    deployment_.hosts.resize(2);
    deployment_.hosts[0].name = "uxv";
    deployment_.hosts[0].role = Role::uxv;
    deployment_.hosts[1].name = "gcs";
    deployment_.hosts[1].role = Role::gcs;
    deployment_.hosts[0].containers.emplace_back().name = "drive";
  }
  void add_program(const std::vector<std::string>& command) {
    deployment_.hosts[0].programs.push_back({"base", command});
  }
  [[nodiscard]] std::vector<std::string> errors() const {
    std::vector<std::string> texts;
    for (const Finding& finding : examine_programs(deployment_, {folder_.path()})) {
      EXPECT_EQ(finding.severity, Severity::error);
      texts.push_back(finding.text);
    }
    return texts;
  }
  const TemporaryFolder folder_;
  deployment::Deployment deployment_;
};

TEST_F(ExamineProgramsTest, SaysNothingOfProgramsThatAreThereAndRunsNoneOfAnotherKind) {
  add_program({"robot", "--start"});
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_EQ(folder_.read("asked"), "");
}

TEST_F(ExamineProgramsTest, FindsAProgramThatDoesNotExist) {
  add_program({"robott"});
  ASSERT_EQ(errors().size(), 1U);
  EXPECT_THAT(errors()[0], HasSubstr("uxv/base: program 'robott' is not found"));
}

TEST_F(ExamineProgramsTest, AsksTheSimulatedBaseAboutItsArguments) {
  add_program({"kobuki_simulator", "--start", "0,0"});
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_EQ(folder_.read("asked"), "--start 0,0 --check\n");
  (void)folder_.write_program("kobuki_simulator", "echo kobuki_simulator: bad pose >&2; exit 2");
  EXPECT_THAT(errors(), ::testing::ElementsAre("uxv/base: kobuki_simulator: bad pose"));
}

TEST_F(ExamineProgramsTest, AsksTheRadioAboutItsFiles) {
  deployment_.radio = deployment::Radio{"/c.yaml", "/w.yaml"};
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_THAT(folder_.read("asked"), HasSubstr("--channel /c.yaml --walls /w.yaml"));
  EXPECT_THAT(folder_.read("asked"), HasSubstr(" --check\n"));
  (void)folder_.write_program("link_emulator", "kill -9 $$");
  EXPECT_THAT(errors(), ::testing::ElementsAre("radio: ends with 137"));
}

}  // namespace
}  // namespace tocsin::check
