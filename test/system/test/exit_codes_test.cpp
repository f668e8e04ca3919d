// SPDX-License-Identifier: Apache-2.0
// The table of exit codes (components/framework/command_line/README.md), for the same kind of
// mistake in every command. Nothing runs in the domain that the commands are told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

const std::string nowhere = " --domain 98";

struct ExitCodes : ::testing::Test {
  /// `tocsin WORDS` ends with the code, and says `reason` in one line.
  static void expect(int code, const std::string& words, const std::string& reason = "") {
    const Ended ended = run_to_end(Stack::program("tocsin"), words);
    EXPECT_EQ(ended.code, code) << words << "\n" << ended.output;
    EXPECT_THAT(ended.output, HasSubstr(reason)) << words;
  }
  static void expect_simulator(int code, const std::string& words, const std::string& reason) {
    const Ended ended = run_to_end(Stack::program("kobuki_simulator"), words);
    EXPECT_EQ(ended.code, code) << words << "\n" << ended.output;
    EXPECT_THAT(ended.output, HasSubstr(reason)) << words;
  }
};

TEST_F(ExitCodes, AVerbThatIsNoneIsTwo) {
  expect(2, "lanch dock.yaml", "'lanch' is not a verb; did you mean 'launch'?");
  expect(2, "qos lnit", "'lnit' is not a verb; did you mean 'lint'?");
  expect(2, "topic ehco /odom", "'ehco' is not a verb; did you mean 'echo'?");
  expect(2, "keystore crate", "'crate' is not a verb; did you mean 'create'?");
}

TEST_F(ExitCodes, AnOptionThatIsNoneIsTwo) {
  expect(2, "sim dock.yaml --sed 1",
         "--sed: there is no such option; did you mean '--set' or '--seed'");
  expect(2, "check dock.yaml --strct", "did you mean '--strict'?");
  expect(2, "qos lint --stram x", "did you mean '--stream'?");
  expect_simulator(2, "--lnk /tmp/x", "kobuki_simulator: --lnk: there is no such option");
}

TEST_F(ExitCodes, ASeedThatIsNoneIsTwo) {
  for (const char* command : {"sim dock.yaml", "launch dock.yaml", "check dock.yaml"}) {
    expect(2, std::string(command) + " --seed -1",
           "--seed: '-1' is not a whole number from 0 to 2147483647\n");
  }
  expect_simulator(2, "--link /tmp/x --seed -1", "--seed: '-1' is not a whole number from 0");
}

TEST_F(ExitCodes, AFileThatIsNotThereIsTwo) {
  for (const char* command :
       {"launch nowhere.yaml", "check nowhere.yaml", "sim nowhere.yaml", "doctor nowhere.yaml",
        "experiment run nowhere.yaml", "report nowhere", "decide nowhere.csv", "bag info nowhere",
        "qos lint --file nowhere.yaml", "qos tune nowhere.yaml"}) {
    expect(2, command, "nowhere");
  }
}

TEST_F(ExitCodes, AFileIsLookedAtBeforeARunningSystem) {
  expect(2, "bag play nowhere" + nowhere, "nowhere");
  expect(2, "param load /driver nowhere.yaml" + nowhere, "nowhere.yaml");
  expect(2, "qos match /odom state --file nowhere.yaml" + nowhere, "nowhere.yaml");
  expect(2, "qos set /odom deadlin_s=1" + nowhere, "did you mean 'deadline_s'?");
  expect(2, "topic pub /a std_msgs/msg/Strin '{}'" + nowhere, "std_msgs/msg/Strin");
  expect(2, "topic pub /a std_msgs/msg/String '{dta: 1}'" + nowhere, "did you mean 'data'?");
}

TEST_F(ExitCodes, ATabInAFileIsTwoAndCalledATab) {
  const TemporaryFolder folder;
  const std::string path = folder.write("tab.yaml", "hosts:\n\tuxv: {}\n");
  for (const char* command : {"launch ", "check ", "sim "}) {
    expect(2, command + path, path + ":2: not valid YAML: a tab in the indentation");
  }
}

TEST_F(ExitCodes, ANameThatTheFilesHaveNotIsTwo) {
  expect(2, "qos show sensr", "did you mean 'sensor'?");
  expect(2, "qos lint --stream sensr", "did you mean 'sensor'?");
  expect(2, "check dock.yaml --without uxv/bas", "did you mean 'uxv/base'?");
  expect(2, "check dock.yaml --set navigatr.x=1", "navigatr: no such component");
  expect(2, "check dock.yaml --set auto_dockign.timeout_s=9", "did you mean 'auto_docking'?");
  expect(2, "check dock.yaml --set auto_docking.timout_s=9", "did you mean 'timeout_s'?");
  expect(2, "check mission.yaml --set transmission_controller.policy=tocp_dps",
         "did you mean 'tocp_dsp'?");
}

TEST_F(ExitCodes, AComponentThatIsNotInstalledIsTwo) {
  expect(2, "run navigatr", "did you mean 'navigator'?");
  expect(2, "component info navigatr", "did you mean 'navigator'?");
}

TEST_F(ExitCodes, WhatTheRunningSystemHasNotIsOne) {
  expect(1, "node info /no" + nowhere, "'/no'");
  expect(1, "topic type /no" + nowhere, "/no");
  expect(1, "service type /no" + nowhere, "/no");
  expect(1, "action info /no" + nowhere, "/no");
  expect(1, "param get /no x" + nowhere, "/no");
  expect(1, "component list" + nowhere, "no container runs on this host");
  expect(1, "component load no navigator --timeout 0.3" + nowhere, "no: no such container");
  expect(1, "component unload no navigator --timeout 0.3" + nowhere, "no: no such container");
  expect(1, "log list --spin-time 0.5" + nowhere, "tocsin log: nothing runs here");
  expect(1, "qos match /no" + nowhere, "/no");
  expect(1, "qos set /no deadline_s=1 --spin-time 0.2" + nowhere,
         "nobody writes or reads /no here");
}

TEST_F(ExitCodes, ANoIsOne) {
  expect(1, "qos match event state", "do not match");
  expect(1, "qos lint --direct", "foreign-clocks");
}

}  // namespace
}  // namespace tocsin
