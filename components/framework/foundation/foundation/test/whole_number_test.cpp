// SPDX-License-Identifier: Apache-2.0
#include "foundation/whole_number.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

std::string error_of(const std::string& text) {
  try {
    return std::to_string(whole_number(text, "KILLS", 1, 20));
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(WholeNumber, IsAllOfItsText) {
  EXPECT_EQ(error_of("1"), "1");
  EXPECT_EQ(error_of("20"), "20");
  EXPECT_EQ(whole_number("18446744073709551615", "n", 0, UINT64_MAX), UINT64_MAX);
}

TEST(WholeNumber, NamesWhatIsWrongAndWhatIsAllowed) {
  for (const std::string text :
       {"", "0", "21", "-1", "+1", " 1", "1 ", "1.5", "abc", "99999999999999999999"}) {
    EXPECT_EQ(error_of(text), "KILLS: '" + text + "' is no whole number of 1 to 20");
  }
}

}  // namespace
}  // namespace tocsin
