// SPDX-License-Identifier: Apache-2.0
// bringup/packaging/tocsin@.service, as systemd itself reads it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

struct Outcome {
  int code;
  std::string text;  ///< both outputs
};

Outcome run(const std::string& command) {
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 256> part{};
  while (fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

/// The shipped unit with programs that are there.
std::string unit_text() {
  std::ostringstream text;
  text << std::ifstream(TOCSIN_REPOSITORY "/bringup/packaging/tocsin@.service").rdbuf();
  std::string unit = text.str();
  const std::string program = "/usr/bin/tocsin";
  const auto at = unit.find(program);
  if (at != std::string::npos) unit.replace(at, program.size(), "/bin/true");
  return unit;
}

class ServiceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string plain =
        folder_.write("plain.service", "[Service]\nType=exec\nExecStart=/bin/true\n");
    if (run("systemd-analyze verify " + plain).code != 0) {
      GTEST_SKIP() << "systemd-analyze is not there, or verifies nothing here";
    }
  }
  const TemporaryFolder folder_;
};

TEST_F(ServiceTest, IsAValidUnit) {
  const Outcome outcome =
      run("systemd-analyze verify " + folder_.write("tocsin@vehicle.service", unit_text()));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, ::testing::Not(::testing::HasSubstr("tocsin@vehicle.service:")));
}

// In tenths of systemd's scale, on which an ordinary service has 92 to 96.
TEST_F(ServiceTest, LeavesAlmostNothingToWhoTakesItOver) {
  const std::string security = "systemd-analyze security --offline=true --threshold=20 ";
  if (run("systemd-analyze --help").text.find("--offline") == std::string::npos) {
    GTEST_SKIP() << "this systemd rates no files";
  }
  const Outcome outcome = run(security + folder_.write("tocsin@vehicle.service", unit_text()));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
}

}  // namespace
}  // namespace tocsin
