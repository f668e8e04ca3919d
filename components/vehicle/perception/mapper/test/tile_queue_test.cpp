// SPDX-License-Identifier: Apache-2.0
#include "mapper/tile_queue.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using Index = TileQueue::Index;

TEST(TileQueue, SendsWhatHasChangedLongestAgoFirst) {
  TileQueue sut;
  EXPECT_FALSE(sut.next_changed());
  for (const Index index : {Index{1, 0}, Index{0, 0}, Index{1, 0}, Index{-1, 5}})
    sut.on_change(index);
  EXPECT_EQ(sut.next_changed(), (Index{1, 0}));
  sut.on_change({1, 0});
  EXPECT_EQ(sut.next_changed(), (Index{0, 0}));
  EXPECT_EQ(sut.next_changed(), (Index{-1, 5}));
  EXPECT_EQ(sut.next_changed(), (Index{1, 0}));
  EXPECT_FALSE(sut.next_changed());
}

TEST(TileQueue, RepeatsAllInTurnWhileNothingHasChanged) {
  TileQueue sut;
  EXPECT_FALSE(sut.next_repeat());
  for (const Index index : {Index{0, 0}, Index{1, 0}, Index{2, 0}}) sut.on_change(index);
  EXPECT_FALSE(sut.next_repeat()) << "what has changed goes first";
  while (sut.next_changed()) {
  }
  for (int round = 0; round < 2; ++round) {
    for (const Index index : {Index{0, 0}, Index{1, 0}, Index{2, 0}}) {
      EXPECT_EQ(sut.next_repeat(), index);
    }
  }
  sut.on_change({0, 0});
  (void)sut.next_changed();
  EXPECT_EQ(sut.next_repeat(), (Index{1, 0}));
}

}  // namespace
}  // namespace tocsin
