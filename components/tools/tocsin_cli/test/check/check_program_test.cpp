// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it, on files without components: what it prints, writes and returns.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::check {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A ground station with a program of its own.
std::string bringup(int domain, const std::string& program = "true") {
  return "qos: qos.yaml\ntraffic: traffic.yaml\ndomain: " + std::to_string(domain) +
         "\nhosts:\n  gcs:\n    role: gcs\n    address: 10.0.0.2\n    programs:\n"
         "      - {name: base, command: [" +
         program + "]}\n";
}

class CheckProgram : public ::testing::Test {
 protected:
  CheckProgram() {
    folder_.write("qos.yaml", "");
    folder_.write("traffic.yaml", "");
    folder_.write("good.yaml", bringup(40));
    folder_.write("high.yaml", bringup(102));
  }
  [[nodiscard]] Ended check(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), CHECK_PROGRAM);
    return run_to_end(arguments, {"", folder_.path()});
  }
  const TemporaryFolder folder_;
};

TEST_F(CheckProgram, SaysThatAFileIsGood) {
  const Ended ended = check({"good.yaml"});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_EQ(ended.output, "good.yaml: 0 components; 0 errors, 0 warnings\n");
}

TEST_F(CheckProgram, AWarningIsNoErrorUnlessItIsWanted) {
  const Ended ended = check({"high.yaml"});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output,
              AllOf(StartsWith("warning: domain 102 of gcs"), HasSubstr(" 0 errors")));
  EXPECT_EQ(check({"high.yaml", "--strict"}).code, 2);
  EXPECT_EQ(check({"good.yaml", "--strict"}).code, 0);
}

TEST_F(CheckProgram, QuietPrintsErrorsOnly) {
  EXPECT_EQ(check({"high.yaml", "--quiet"}).output, "");
  folder_.write("bad.yaml", bringup(40, "no_such_program"));
  const Ended ended = check({"bad.yaml", "--quiet"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(StartsWith("error: "), HasSubstr("no_such_program")));
  EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
}

TEST_F(CheckProgram, AComponentThatIsNotInstalledIsAnErrorInOneLine) {
  folder_.write("bad.yaml",
                bringup(40) + "    containers:\n      - {name: drive, components: [navigatr]}\n");
  const Ended ended = check({"bad.yaml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("navigatr"), HasSubstr("bad.yaml:")));
}

TEST_F(CheckProgram, WhatItIsToldWrongIsCodeTwoAndNothingElseIsPrinted) {
  EXPECT_EQ(check({"nowhere.yaml"}).code, 2);
  EXPECT_EQ(check({"good.yaml", "--quiet", "--strict"}).code, 2);
  EXPECT_EQ(check({}).code, 2);
  const Ended ended = check({"good.yaml", "--set", "navigator.speed_mps=1"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("navigator"), Not(HasSubstr("0 errors"))));
}

}  // namespace
}  // namespace tocsin::check
