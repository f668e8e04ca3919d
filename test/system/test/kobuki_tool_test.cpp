// SPDX-License-Identifier: Apache-2.0
// `tocsin kobuki` as a user runs it, against the simulated base behind its pseudo-terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;

class KobukiToolTest : public ::testing::Test {
 protected:
  /// Starts the simulated base and plays a script of faults from then on.
  void start_base(const std::string& script = "") {
    std::vector<std::string> words{Stack::program("kobuki_simulator"),
                                   "--link",
                                   folder_.path("port"),
                                   "--control",
                                   folder_.path("control"),
                                   "--script",
                                   folder_.write("script", script)};
    base_.emplace(words, folder_.path("base.out"));
    EXPECT_TRUE(Stack::eventually(seconds(10), [&] {
      return std::filesystem::exists(folder_.path("port")) &&
             std::filesystem::exists(folder_.path("control"));
    }));
  }
  /// Runs `tocsin kobuki` to its end; its exit code.
  int tool(std::vector<std::string> words) {
    words.insert(words.begin(), Stack::program("tocsin-kobuki"));
    words.insert(words.end(), {"--port", folder_.path("port")});
    std::filesystem::remove(folder_.path("out"));
    return OperatorProcess(words, folder_.path("out")).exit_code(seconds(100));
  }

  const TemporaryFolder folder_;
  std::optional<OperatorProcess> base_;
};

TEST_F(KobukiToolTest, PassesItsAcceptanceListOnTheSimulatedBase) {
  start_base();
  EXPECT_EQ(tool({"test", "--auto", folder_.path("control")}), 0) << folder_.read("out");
  EXPECT_THAT(folder_.read("out"), HasSubstr("15 passed, 0 failed, 0 skipped"));
}

TEST_F(KobukiToolTest, TellsVersionsAndBattery) {
  start_base();
  EXPECT_EQ(tool({"info"}), 0);
  EXPECT_THAT(folder_.read("out"), AllOf(HasSubstr("firmware"), HasSubstr("battery")));
}

// acceptance_test and verbs_test of kobuki_tool pull it at every moment, in virtual time.
TEST_F(KobukiToolTest, FailsItsAcceptanceListWhenTheCableIsPulled) {
  for (const char* script : {"1 unplug", "5 unplug"}) {
    start_base(script);
    EXPECT_EQ(tool({"test", "--auto", folder_.path("control")}), 1);
    EXPECT_THAT(folder_.read("out"), HasSubstr(" 1 failed, 0 skipped")) << folder_.read("out");
    EXPECT_THAT(folder_.read("out"), HasSubstr("the port was lost: is its cable out?"));
  }
}

TEST_F(KobukiToolTest, SaysThatTheCableWasPulledWhileItWatches) {
  start_base("1 unplug");
  EXPECT_EQ(tool({"watch"}), 1);
  EXPECT_THAT(folder_.read("out"), HasSubstr("no port"));
  EXPECT_THAT(folder_.read("out"), HasSubstr("the port was lost: is its cable out?"));
}

TEST_F(KobukiToolTest, SaysThatNoBaseSends) {
  start_base("0 silence 1000");
  EXPECT_EQ(tool({"info"}), 1);
  EXPECT_THAT(folder_.read("out"), HasSubstr("no base is sending there"));
}

TEST_F(KobukiToolTest, AsksForATerminalWhenAPersonMustAnswer) {
  start_base();
  EXPECT_EQ(tool({"test"}), 2);
  EXPECT_THAT(folder_.read("out"), HasSubstr("--auto"));
}

TEST_F(KobukiToolTest, NamesAPortThatIsNotThereInOneLine) {
  OperatorProcess sut({Stack::program("tocsin-kobuki"), "info", "--port", folder_.path("other")},
                      folder_.path("out"));
  EXPECT_EQ(sut.exit_code(seconds(10)), 1);
}

}  // namespace
}  // namespace tocsin
