// SPDX-License-Identifier: Apache-2.0
// The sessions of the pages of `tocsin topic` and `tocsin qos`, as they stand there, on real DDS.
#include <gtest/gtest.h>

#include "readme.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

const std::string tools = TOCSIN_REPOSITORY "/components/tools/dds_tools/";
const std::string topic_page = tools + "topic_tool/README.md";
const std::string qos_page = tools + "qos_tool/README.md";

void expect_played(const std::string& page, int number) {
  const ConsoleSession session = readme_sessions(page).at(static_cast<std::size_t>(number));
  ASSERT_FALSE(session.prints.empty());
  const TemporaryFolder folder;
  const std::string prelude = "export ROS_DOMAIN_ID=48\nsource " + Stack::setup();
  EXPECT_EQ(play(session, folder, prelude, seconds(30)), "");
}

auto sessions_of(const std::string& page) {
  return ::testing::Range(0, static_cast<int>(readme_sessions(page).size()));
}

class TopicPage : public ::testing::TestWithParam<int> {};
class QosPage : public ::testing::TestWithParam<int> {};

TEST_P(TopicPage, PrintsWhatThePageSays) { expect_played(topic_page, GetParam()); }
TEST_P(QosPage, PrintsWhatThePageSays) { expect_played(qos_page, GetParam()); }

INSTANTIATE_TEST_SUITE_P(Sessions, TopicPage, sessions_of(topic_page));
INSTANTIATE_TEST_SUITE_P(Sessions, QosPage, sessions_of(qos_page));

}  // namespace
}  // namespace tocsin
