// SPDX-License-Identifier: Apache-2.0
#include "link_router/reader_wait.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Time begin{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);

TEST(ReaderWait, LastsAsLongAsItMayWithoutReaders) {
  const ReaderWait sut(2000 * ms, begin);
  EXPECT_FALSE(sut.is_over(begin + 1999 * ms));
  EXPECT_TRUE(sut.is_over(begin + 2000 * ms));
}

TEST(ReaderWait, EndsWhenNoReaderFollowsTheLast) {
  ReaderWait sut(2000 * ms, begin);
  sut.on_reader(begin + 50 * ms);
  sut.on_reader(begin + 150 * ms);
  EXPECT_FALSE(sut.is_over(begin + 349 * ms));
  EXPECT_TRUE(sut.is_over(begin + 350 * ms));
  sut.on_reader(begin + 400 * ms);
  EXPECT_TRUE(sut.is_over(begin + 401 * ms)) << "once over it does not begin again";
}

TEST(ReaderWait, ReadersDoNotMakeItLonger) {
  ReaderWait sut(2000 * ms, begin);
  sut.on_reader(begin + 1900 * ms);
  EXPECT_EQ(sut.end(), begin + 2000 * ms);
}

}  // namespace
}  // namespace tocsin::router
