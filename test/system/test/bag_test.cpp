// SPDX-License-Identifier: Apache-2.0
// The sessions of the page of `tocsin bag`, as they stand there, on real DDS.
#include <gtest/gtest.h>

#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

const std::string page = TOCSIN_REPOSITORY "/components/tools/recording_tools/bag_tool/README.md";

class BagPage : public ::testing::TestWithParam<int> {};

TEST_P(BagPage, PrintsWhatThePageSays) {
  const ConsoleSession session = readme_sessions(page).at(static_cast<std::size_t>(GetParam()));
  ASSERT_FALSE(session.prints.empty());
  const TemporaryFolder folder;
  const std::string prelude = "export ROS_DOMAIN_ID=49\nsource " + Stack::setup();
  EXPECT_EQ(play(session, folder, prelude, seconds(30)), "");
}

INSTANTIATE_TEST_SUITE_P(Sessions, BagPage,
                         ::testing::Range(0, static_cast<int>(readme_sessions(page).size())));

}  // namespace
}  // namespace tocsin
