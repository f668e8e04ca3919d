// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "foundation/csv_table.hpp"
#include "plan/toy.hpp"

namespace tocsin::experiment {

namespace fs = std::filesystem;

struct Ended {
  int code;
  std::string output;
};

/// Runs a shell command, at most two minutes long.
inline Ended call_shell(const std::string& command, const TemporaryFolder& folder) {
  const std::string script = folder.write("command", command);
  const std::string whole = "timeout 120 sh " + script + " >" + folder.path("output") + " 2>&1";
  const int status = std::system(whole.c_str());
  return {WEXITSTATUS(status), folder.read("output")};
}

inline bool succeeds(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// The installed program.
inline std::string program() { return std::string(TOCSIN_INSTALL) + "/bin/tocsin-experiment"; }
inline std::string config(const std::string& name) {
  return std::string(TOCSIN_REPOSITORY) + "/config/" + name;
}

/// What a slice of an experiment has of its own.
struct Slice {
  std::string policies = "  - {name: none}\n  - {name: tocp_dsp}\n";
  int seeds = 1;
  std::string kind = "thesis";
  std::string channel = config("radio/thesis_a.yaml");
  int duration_s = 40;
};

/// Runs of Mission A without camera.
inline std::string text_of(const Slice& slice) {
  return "duration_s: " + std::to_string(slice.duration_s) +
         "\nwarm_up_s: 5\nobservation_s: 3\nmissions:\n  - {name: a, file: " +
         config("missions/mission_a.yaml") +
         "}\nchannels:\n  - {name: thesis, file: " + slice.channel +
         "}\npayloads:\n  - {name: plain}\npolicies:\n" + slice.policies +
         "sets:\n  - {name: main, kind: " + slice.kind + ", seeds: " + std::to_string(slice.seeds) +
         "}\n";
}

class ExperimentTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(program())) GTEST_SKIP() << program() << " is not installed";
  }
  Ended call(const std::string& arguments, const std::string& before = "") {
    return call_shell(before + " " + program() + " " + arguments, folder_);
  }
  Ended run(const Slice& slice, const std::string& out, const std::string& before = "") {
    const std::string file = folder_.write("experiment.yaml", text_of(slice));
    return call("run " + file + " --jobs 2 --out " + folder_.path(out), before);
  }
  [[nodiscard]] CsvTable table(const std::string& name) const {
    return CsvTable::read(folder_.path(name));
  }
  TemporaryFolder folder_;
};

}  // namespace tocsin::experiment
