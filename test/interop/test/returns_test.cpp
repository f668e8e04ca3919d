// SPDX-License-Identifier: Apache-2.0
// A slice of `returns`: participants of all makers on two hosts, joined by routers over the
// emulated radio, which is dead for a while, and one of which is stopped.
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

// It takes 0.1 to 0.5 s where the machine has time.
constexpr milliseconds bound{4000};
// What a busy machine takes to hand a sample on comes on top of its lifespan.
constexpr milliseconds slack{1000};

TEST(Returns, AllHearEachOtherAfterAnOutageAndAfterARouterWasStoppedAndNobodyIsGivenWhatIsTooOld) {
  RoutedPeers sut;
  // The readers of its host have forgotten the router by then: its lease is 5 s.
  for (const Interruption& what : {Interruption{"", seconds(6)}, {"gcs/link", seconds(7)}}) {
    const Return result = sut.after(what);
    EXPECT_LE(result.longest, bound) << to_text(what) << ", ms";
    EXPECT_LE(result.oldest, RoutedPeers::lifespan + slack)
        << to_text(what) << ", ms: " << result.oldest_is;
  }
}

}  // namespace
}  // namespace tocsin::interop
