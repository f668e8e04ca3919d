// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

TEST(LinkRouterParams, RefusesWhatIsOutOfOrderAndNamesIt) {
  LinkRouterParams params;
  params.hold_backlog_s = 0;
  try {
    const LinkSender sut(params);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("link_router.hold_backlog_s: 0 is below"));
  }
}

TEST(LinkRouterReadme, ShowsTheParameters) {
  std::ifstream file(TOCSIN_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, ::testing::HasSubstr(default_yaml<LinkRouterParams>()));
}

}  // namespace
}  // namespace tocsin::router
