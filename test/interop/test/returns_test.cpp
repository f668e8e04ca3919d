// SPDX-License-Identifier: Apache-2.0
// A slice of `returns`: participants of all makers on two hosts, joined by routers over the
// emulated radio, which is dead for a while.
#include <gtest/gtest.h>

#include "returns.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Interruption, IsToldInWords) {
  EXPECT_EQ(to_text({"", seconds(10)}), "outage of 10 s");
  EXPECT_EQ(to_text({"gcs/link", seconds(7)}), "gcs/link stopped for 7 s");
}

TEST(Returns, AfterAnOutageAllHearEachOtherAndNobodyIsGivenWhatHasOutlivedItsLifespan) {
  RoutedPeers sut;
  // It takes 0.1 s where the machine has time.
  constexpr milliseconds bound{4000};
  // What a busy machine takes to hand a sample on comes on top.
  constexpr milliseconds slack{1000};
  const Return result = sut.after({"", seconds(6)});
  EXPECT_LE(result.longest, bound) << "ms";
  EXPECT_LE(result.oldest, RoutedPeers::lifespan + slack) << "ms: " << result.oldest_is;
}

}  // namespace
}  // namespace tocsin::interop
