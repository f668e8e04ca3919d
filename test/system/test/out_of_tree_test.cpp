// SPDX-License-Identifier: Apache-2.0
// A user's own workspace over ours, made of nothing but what the page of tocsin_cmake shows:
// message type, topic, QoS profile, traffic class and components of their own, built by colcon
// after `source install/setup.bash`, run by their names and by a bringup file of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "foundation/temporary_folder.hpp"
#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string page =
    std::string(TOCSIN_REPOSITORY) + "/components/framework/tocsin_cmake/README.md";

// Compilers warn of it.
constexpr const char* careless = "\nstatic int careless(double x) { int unused = x; return 0; }\n";

std::string with(std::string text, const std::string& word, const std::string& other) {
  return text.replace(text.find(word), word.size(), other);
}

class OutOfTreeTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    workspace_ = new TemporaryFolder;
    for (const ReadmeBlock& block : readme_files(page)) {
      const bool source = block.file == "src/lamps/src/lamp.cpp";
      if (!block.file.empty()) workspace_->write(block.file, block.text + (source ? careless : ""));
    }
    build_ = readme_sessions(page).at(0);
    build_.script = with(build_.script, "~/tocsin/install/setup.bash", Stack::setup());
    failure_ =
        play(build_, *workspace_, "export CXXFLAGS='-Wall -Wextra -Wconversion'", seconds(200));
  }
  static void TearDownTestSuite() { delete workspace_; }
  void SetUp() override { ASSERT_EQ(failure_, ""); }

  /// What went wrong in a session of a person who has sourced both.
  static std::string play_sourced(const ConsoleSession& session) {
    return play(session, *workspace_,
                "source " + Stack::setup() + "\nsource install/setup.bash\nexport ROS_DOMAIN_ID=73",
                seconds(30));
  }
  static TemporaryFolder* workspace_;
  static ConsoleSession build_;
  static std::string failure_;
};

TemporaryFolder* OutOfTreeTest::workspace_ = nullptr;
ConsoleSession OutOfTreeTest::build_;
std::string OutOfTreeTest::failure_;

TEST_F(OutOfTreeTest, WarningsOfUsersAreNoErrors) {
  EXPECT_THAT(workspace_->read("log/latest_build/lamps/stderr.log"), HasSubstr("warning"));
}

TEST_F(OutOfTreeTest, TheirComponentsAreListedWithOursOnceTheirWorkspaceIsSourced) {
  EXPECT_EQ(play_sourced({"tocsin component types",
                          {"lamp                     lamps", "navigator                driving"},
                          1001}),
            "");
  EXPECT_EQ(play({"tocsin component types; echo end", {"end"}, 1002}, *workspace_,
                 "source " + Stack::setup(), seconds(30)),
            "");
  EXPECT_THAT(workspace_->read("session1002.out"), Not(HasSubstr("lamp")));
}

TEST_F(OutOfTreeTest, EverySessionOfThePagePrintsWhatThePageSays) {
  const auto sessions = readme_sessions(page);
  EXPECT_GE(sessions.size(), 3U);
  for (std::size_t i = 1; i < sessions.size(); ++i) EXPECT_EQ(play_sourced(sessions[i]), "");
}

TEST_F(OutOfTreeTest, TheirTopicIsRecordedAndTheirFileRunsInVirtualTimeToo) {
  EXPECT_EQ(play_sourced({"tocsin sim lamps.yaml --duration 10 --run-dir first\n"
                          "tocsin bag export first/uxv/bag -o csv\n"
                          "cat csv/lamp.csv\necho end",
                          {"10.000 s simulated ...", "...,brightness", "...,40", "...,40", "end"},
                          1003}),
            "");
}

TEST_F(OutOfTreeTest, WithoutTheirQosProfileOrTrafficClassTheCheckNamesTopicAndFile) {
  workspace_->write("plain.yaml",
                    with(workspace_->read("lamps.yaml"), "qos: qos.yaml", "qos: shipped/qos.yaml"));
  workspace_->write("shipped/qos.yaml", "extends: qos.yaml\n");
  EXPECT_EQ(play_sourced({"! tocsin check plain.yaml", {"...lamp...lamp_order..."}, 1004}), "");
  workspace_->write("mute.yaml", with(workspace_->read("lamps.yaml"), "traffic: traffic.yaml",
                                      "traffic: shipped/traffic.yaml"));
  workspace_->write("shipped/traffic.yaml", "extends: traffic.yaml\n");
  EXPECT_EQ(play_sourced({"! tocsin check mute.yaml", {"...lamp...traffic.yaml..."}, 1005}), "");
}

}  // namespace
}  // namespace tocsin
