// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/writer_proxy.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tocsin::rtps {
namespace {

using Sequences = std::vector<Sequence>;

TEST(WriterProxy, SamplesInOrderAreAvailableAtOnce) {
  WriterProxy sut;
  EXPECT_TRUE(sut.settle(1));
  EXPECT_TRUE(sut.settle(2));
  EXPECT_EQ(sut.available(), 2U);
  EXPECT_FALSE(sut.settle(2));
}

TEST(WriterProxy, OneBehindAMissingOneWaits) {
  WriterProxy sut;
  EXPECT_TRUE(sut.settle(1));
  EXPECT_TRUE(sut.settle(3));
  EXPECT_EQ(sut.available(), 1U);
  EXPECT_TRUE(sut.has(3));
  EXPECT_FALSE(sut.has(2));
  EXPECT_EQ(sut.missing(), Sequences{2});
  EXPECT_TRUE(sut.settle(2));
  EXPECT_EQ(sut.available(), 3U);
  EXPECT_TRUE(sut.missing().empty());
}

TEST(WriterProxy, AHistoryTellsWhatIsGoneAndWhatExists) {
  WriterProxy sut;
  sut.on_history(4, 6);
  EXPECT_EQ(sut.available(), 3U);
  EXPECT_EQ(sut.missing(), (Sequences{4, 5, 6}));
}

TEST(WriterProxy, AnEmptyHistorySettlesAllBeforeIt) {
  WriterProxy sut;
  sut.on_history(6, 5);
  EXPECT_EQ(sut.available(), 5U);
  EXPECT_TRUE(sut.missing().empty());
}

TEST(WriterProxy, AHistoryReleasesWhatWaitedForTheSamplesThatAreGone) {
  WriterProxy sut;
  sut.settle(3);
  sut.settle(4);
  sut.on_history(3, 4);
  EXPECT_EQ(sut.available(), 4U);
}

TEST(WriterProxy, AHistoryThatBeginsWithTheNextSampleSettlesNothing) {
  WriterProxy sut;
  sut.settle(1);
  sut.on_history(2, 3);
  EXPECT_EQ(sut.available(), 1U);
  EXPECT_EQ(sut.missing(), (Sequences{2, 3}));
}

TEST(WriterProxy, CountsWhatIsMissingBeforeASample) {
  WriterProxy sut;
  EXPECT_EQ(sut.missing_before(1), 0U);
  EXPECT_EQ(sut.missing_before(4), 3U);
  sut.settle(2);
  EXPECT_EQ(sut.missing_before(4), 2U);
  sut.settle(1);
  EXPECT_EQ(sut.missing_before(2), 0U);
}

TEST(WriterProxy, NamesTheFirst256OfThoseThatAreMissing) {
  WriterProxy sut;
  sut.on_history(1, 256);
  EXPECT_EQ(sut.missing().size(), 256U);
  sut.on_history(1, 257);
  EXPECT_EQ(sut.missing().size(), 256U);
  EXPECT_EQ(sut.missing().back(), 256U);
}

}  // namespace
}  // namespace tocsin::rtps
