// SPDX-License-Identifier: Apache-2.0
#include "rtps_filter/drop_account.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace tocsin::rtps_filter {
namespace {

TEST(DropReason, EachHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < drop_reasons; ++i) names.insert(to_text(DropReason(i)));
  EXPECT_EQ(names.size(), drop_reasons);
  EXPECT_EQ(names.count(""), 0U);
  EXPECT_EQ(to_text(DropReason::too_many_bytes), "too_many_bytes");
}

TEST(Source, IsWrittenDotted) { EXPECT_EQ(to_text(ipv4(10, 0, 200, 1)), "10.0.200.1"); }

TEST(DropAccount, CountsByReasonAndSource) {
  DropAccount sut;
  EXPECT_EQ(sut.total(), 0U);
  sut.add(DropReason::gap_range, 1);
  sut.add(DropReason::gap_range, 2);
  sut.add(DropReason::not_rtps, 2);
  EXPECT_EQ(sut.total(), 3U);
  EXPECT_EQ(sut.count(DropReason::gap_range), 2U);
  EXPECT_EQ(sut.by_source().at(2)[static_cast<std::size_t>(DropReason::not_rtps)], 1U);
}

TEST(DropAccount, TellsWhatWasAddedSince) {
  DropAccount sut;
  sut.add(DropReason::gap_range, 1);
  sut.add(DropReason::gap_range, 2);
  const DropAccount before = sut;
  EXPECT_EQ(sut.since(before).total(), 0U);
  sut.add(DropReason::fragment, 2);
  const DropAccount grown = sut.since(before);
  EXPECT_EQ(grown.total(), 1U);
  EXPECT_EQ(grown.count(DropReason::fragment), 1U);
  EXPECT_EQ(grown.by_source().count(1), 0U);
}

TEST(DropAccount, CountsSourcesBeyondTheMostTogether) {
  DropAccount sut;
  for (std::uint32_t address = 1; address <= 100; ++address) {
    sut.add(DropReason::not_rtps, address);
  }
  EXPECT_EQ(sut.total(), 100U);
  EXPECT_EQ(sut.by_source().size(), DropAccount::most_sources + 1);
  EXPECT_EQ(sut.by_source().at(0)[0], 100 - DropAccount::most_sources);
}

TEST(DropAccount, AddsUp) {
  DropAccount one;
  one.add(DropReason::not_rtps, 1);
  DropAccount sut;
  sut.add(DropReason::not_rtps, 1);
  sut.add(one);
  EXPECT_EQ(sut.by_source().at(1)[0], 2U);
}

}  // namespace
}  // namespace tocsin::rtps_filter
