// SPDX-License-Identifier: Apache-2.0
#include "link_router/pending_calls.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

using Pending = PendingCalls<int, std::string>;
const Time t0{std::chrono::seconds(100)};
constexpr Duration second = std::chrono::seconds(1);

TEST(PendingCalls, ACallIsTakenOnce) {
  Pending sut;
  sut.add(1, {"dock", "who", t0 + second});
  const auto call = sut.take(1);
  ASSERT_TRUE(call);
  EXPECT_EQ(call->what, "who");
  EXPECT_FALSE(sut.take(1));
  EXPECT_FALSE(sut.take(2));
}

TEST(PendingCalls, IsOverAtItsDeadlineAndNotBefore) {
  Pending sut;
  EXPECT_EQ(sut.deadline(), never);
  sut.add(1, {"dock", "later", t0 + 2 * second});
  sut.add(2, {"dock", "sooner", t0 + second});
  EXPECT_EQ(sut.deadline(), t0 + second);
  EXPECT_TRUE(sut.take_expired(t0 + second - Duration(1)).empty());
  const auto over = sut.take_expired(t0 + second);
  ASSERT_EQ(over.size(), 1U);
  EXPECT_EQ(over[0].what, "sooner");
  EXPECT_FALSE(sut.take(2));
  EXPECT_TRUE(sut.take(1));
}

TEST(PendingCalls, TheNewestThousandAreKept) {
  Pending sut;
  const int count = static_cast<int>(Pending::most) + 2;
  for (int i = 0; i < count; ++i) sut.add(i, {"dock", "", t0 + second});
  EXPECT_EQ(sut.take_expired(t0).size(), 2U);
  EXPECT_FALSE(sut.take(1));
  EXPECT_TRUE(sut.take(2));
  EXPECT_TRUE(sut.take(count - 1));
}

}  // namespace
}  // namespace tocsin::router
