// SPDX-License-Identifier: Apache-2.0
#include "command_line/said_time.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

TEST(TimeOf, IsSinceTheEpochOrBeforeNow) {
  EXPECT_EQ(time_of("--from", "1700000000.5", 0), 1'700'000'000'500'000'000);
  EXPECT_EQ(time_of("--from", "-60", 1'000'000'000'000), 940'000'000'000);
  EXPECT_EQ(time_of("--to", "0", 1'000'000'000'000), 1'000'000'000'000);
}

TEST(TimeOf, NamesWhatIsNoTime) {
  for (const char* const text : {"", "now", "10:30", "1e99", "-60s", "nan"}) {
    try {
      (void)time_of("--from", text, 0);
      ADD_FAILURE() << text;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--from: '" + std::string(text) + "' is no time"));
    }
  }
}

}  // namespace
}  // namespace tocsin
