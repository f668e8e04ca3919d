// SPDX-License-Identifier: Apache-2.0
// The page of the examples says what is so: each file that it shows is the file of that name, and
// each command prints what stands there.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

const std::string examples = std::string(TOCSIN_REPOSITORY) + "/components/examples";
const std::string page = examples + "/README.md";

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Examples, EveryFileThatThePageShowsIsTheFileOfThatName) {
  const auto shown = readme_files(page);
  EXPECT_GT(shown.size(), 10U);
  for (const ReadmeBlock& block : shown) {
    EXPECT_NE(text_of(examples + "/" + block.file).find(block.text), std::string::npos)
        << "README.md:" << block.line << " is not in '" << block.file << "'";
  }
}

TEST(Examples, NoneWritesWhatMovesOrStopsAVehicle) {
  for (const char* source :
       {"greetings/src/talker.hpp", "greetings/src/listener.hpp", "example_idl/src/topics.cpp",
        "example_idl/include/example_idl/topics.hpp",
        "odometer/include/odometer/odometer_component.hpp"}) {
    const std::string text = text_of(examples + "/" + source);
    EXPECT_FALSE(text.empty()) << source;
    for (const char* dangerous : {"cmd_vel", "CmdVel", "emergency_stop", "EmergencyStop", "Goal"}) {
      EXPECT_EQ(text.find(dangerous), std::string::npos) << source << ": " << dangerous;
    }
  }
}

/// The sessions of the page, one after the other.
class ExamplesSession : public ::testing::TestWithParam<int> {};

TEST_P(ExamplesSession, PrintsWhatThePageSays) {
  const ConsoleSession session = readme_sessions(page).at(static_cast<std::size_t>(GetParam()));
  ASSERT_FALSE(session.prints.empty());
  const TemporaryFolder folder;
  const std::string prelude = "export ROS_DOMAIN_ID=46 RUN=" + folder.path("run") + "\nsource " +
                              Stack::setup() + "\ncp -r " + examples + "/bringup .";
  EXPECT_EQ(play(session, folder, prelude, seconds(30)), "");
}

INSTANTIATE_TEST_SUITE_P(Page, ExamplesSession,
                         ::testing::Range(0, static_cast<int>(readme_sessions(page).size())));

}  // namespace
}  // namespace tocsin
