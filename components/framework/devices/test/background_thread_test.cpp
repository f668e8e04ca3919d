// SPDX-License-Identifier: Apache-2.0
#include "background_thread.hpp"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace tocsin {
namespace {

TEST(BackgroundThread, DoesEachWorkInItsOrderAndAllBeforeItEnds) {
  std::vector<int> done;
  {
    BackgroundThread sut;
    for (int i = 0; i < 100; ++i) sut.post([&done, i] { done.push_back(i); });
  }
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundThread, CountsWhatWaitsAndWhatIsBeingDone) {
  std::promise<void> begun;
  std::promise<void> released;
  BackgroundThread sut;
  sut.post([&] {
    begun.set_value();
    released.get_future().wait();
  });
  sut.post([] {});
  begun.get_future().wait();
  EXPECT_EQ(sut.waiting(), 2U);
  std::promise<void> last;
  sut.post([&] { last.set_value(); });
  released.set_value();
  last.get_future().wait();
  EXPECT_LE(sut.waiting(), 1U);
}

TEST(BackgroundThread, DoesNotBlockWhoPosts) {
  std::promise<void> released;
  BackgroundThread sut;
  sut.post([&] { released.get_future().wait(); });
  sut.post([] {});
  released.set_value();  // reached though the first is not done
}

}  // namespace
}  // namespace tocsin
