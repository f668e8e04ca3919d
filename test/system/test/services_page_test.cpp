// SPDX-License-Identifier: Apache-2.0
// Services and actions with types of a user's own: a workspace made of nothing but what the page
// shows, built, tested and run by the commands that stand there.
#include <gtest/gtest.h>

#include <string>

#include "foundation/temporary_folder.hpp"
#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

const std::string page =
    std::string(TOCSIN_REPOSITORY) + "/components/examples/SERVICES_AND_ACTIONS.md";

TEST(ServicesPageTest, ItsFilesAreBuiltAndTestedAndDoWhatThePageSays) {
  const TemporaryFolder workspace;
  for (const ReadmeBlock& block : readme_files(page)) workspace.write(block.file, block.text);
  auto sessions = readme_sessions(page);
  ASSERT_EQ(sessions.size(), 3U);
  const std::string home = "~/tocsin/install/setup.bash";
  std::string& build = sessions[0].script;
  build.replace(build.find(home), home.size(), Stack::setup());
  ASSERT_EQ(play(sessions[0], workspace, "export CXXFLAGS='-Wall -Wextra -Werror'", seconds(250)),
            "");
  const std::string sourced =
      "source " + Stack::setup() + "\nsource install/setup.bash\nexport ROS_DOMAIN_ID=74";
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    EXPECT_EQ(play(sessions[i], workspace, sourced, seconds(30)), "");
  }
}

}  // namespace
}  // namespace tocsin
