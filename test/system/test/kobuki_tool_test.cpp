// SPDX-License-Identifier: Apache-2.0
// `tocsin kobuki` as a user runs it, against the simulated base behind its pseudo-terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::Not;

class KobukiToolTest : public ::testing::Test {
 protected:
  KobukiToolTest() {
    EXPECT_TRUE(Stack::eventually(seconds(10), [&] {
      return std::filesystem::exists(folder_.path("port")) &&
             std::filesystem::exists(folder_.path("control"));
    }));
  }
  /// Runs `tocsin kobuki` to its end; its exit code.
  int tool(std::vector<std::string> words) {
    words.insert(words.begin(), Stack::program("kobuki_driver", "tocsin-kobuki"));
    words.insert(words.end(), {"--port", folder_.path("port")});
    return OperatorProcess(words, folder_.path("out")).exit_code(seconds(100));
  }

  const TemporaryFolder folder_;
  OperatorProcess base_{{Stack::program("kobuki_simulator", "kobuki_simulator"), "--link",
                         folder_.path("port"), "--control", folder_.path("control")},
                        folder_.path("base.out")};
};

TEST_F(KobukiToolTest, PassesItsAcceptanceListOnTheSimulatedBase) {
  EXPECT_EQ(tool({"test", "--auto", folder_.path("control")}), 0) << folder_.read("out");
  EXPECT_THAT(folder_.read("out"), HasSubstr("15 passed, 0 failed, 0 skipped"));
}

TEST_F(KobukiToolTest, TellsVersionsAndBattery) {
  EXPECT_EQ(tool({"info"}), 0);
  EXPECT_THAT(folder_.read("out"), AllOf(HasSubstr("firmware"), HasSubstr("battery")));
}

TEST_F(KobukiToolTest, NamesAPortThatIsNotThereInOneLine) {
  OperatorProcess sut(
      {Stack::program("kobuki_driver", "tocsin-kobuki"), "info", "--port", folder_.path("other")},
      folder_.path("out"));
  EXPECT_EQ(sut.exit_code(seconds(10)), 1);
}

}  // namespace
}  // namespace tocsin
