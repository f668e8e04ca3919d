// SPDX-License-Identifier: Apache-2.0
#include "rtps/other_vendors.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tocsin {
namespace {

constexpr std::uint32_t here = 0x0a4d0001;
constexpr std::uint32_t there = 0x0a4d0002;
constexpr std::uint8_t cyclone = 0x10;

std::vector<std::uint8_t> packet_of(std::uint8_t vendor) {
  return {'R', 'T', 'P', 'S', 2, 1, 1, vendor, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
}

TEST(OtherVendors, AreWhereOneHasSpoken) {
  OtherVendors sut;
  const auto packet = packet_of(cyclone);
  EXPECT_FALSE(sut.are_at(there));
  sut.hear(packet.data(), packet.size(), there);
  EXPECT_TRUE(sut.are_at(there));
  EXPECT_FALSE(sut.are_at(here));
}

TEST(OtherVendors, AreNotWhereOnlyEProsimaSpeaks) {
  OtherVendors sut;
  const auto packet = packet_of(0x0f);
  sut.hear(packet.data(), packet.size(), there);
  EXPECT_FALSE(sut.are_at(there));
}

TEST(OtherVendors, APacketWithoutAWholeHeaderTellsNothing) {
  OtherVendors sut;
  const auto packet = packet_of(cyclone);
  sut.hear(packet.data(), packet.size() - 1, there);
  sut.hear(packet.data(), 0, there);
  EXPECT_FALSE(sut.are_at(there));
}

}  // namespace
}  // namespace tocsin
