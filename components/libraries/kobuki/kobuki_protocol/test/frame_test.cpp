// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/frame.hpp"

#include <gtest/gtest.h>

#include <random>

#include "frames.hpp"

namespace tocsin::kobuki {
namespace {

TEST(ByteWriter, WritesLittleEndianNumbersThatAReaderReads) {
  std::array<std::uint8_t, 10> bytes{};
  ByteWriter sut(bytes.data(), bytes.size());
  sut.u8(0x01);
  sut.i8(-2);
  sut.u16(0x0403);
  sut.u32(0x08070605);
  sut.i16(-3);
  EXPECT_EQ(to_bytes({bytes.data(), bytes.size()}), from_hex("01 fe 03 04 05 06 07 08 fd ff"));
  ByteReader back({bytes.data(), bytes.size()});
  EXPECT_EQ(back.u8(), 0x01);
  EXPECT_EQ(back.i8(), -2);
  EXPECT_EQ(back.u16(), 0x0403);
  EXPECT_EQ(back.u32(), 0x08070605U);
  EXPECT_EQ(back.i16(), -3);
}

TEST(ByteWriterDeathTest, DoesNotWritePastItsEnd) {
  std::array<std::uint8_t, 3> bytes{};
  ByteWriter sut(bytes.data(), 2);
  sut.u16(1);
  EXPECT_DEATH(sut.u8(1), "");
}

TEST(Frame, LeavesZerosWhereNothingIsWritten) {
  Frame sut;
  auto out = sut.begin(4, 3);
  ASSERT_TRUE(out);
  out->u8(7);
  sut.close();
  EXPECT_EQ(to_bytes(sut.bytes()), from_hex("aa 55 05 04 03 07 00 00 05"));
}

TEST(Frame, TakesNoMoreThanItsPayloadHolds) {
  Frame sut;
  ASSERT_TRUE(sut.begin(1, 200));
  EXPECT_FALSE(sut.begin(2, 52));  // 202 + 54
  EXPECT_TRUE(sut.begin(3, 51));
  sut.close();
  EXPECT_EQ(sut.bytes().size, max_frame);
  EXPECT_EQ(sut.payload()[202], 3);
}

TEST(XorOf, IsThatOfTheSingleBytesAtEveryLengthAndPlace) {
  std::mt19937 random(1);
  Bytes bytes(80);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  for (std::size_t from = 0; from < 9; ++from) {
    std::uint8_t expected = 0;
    for (std::size_t size = 0; from + size < bytes.size(); ++size) {
      EXPECT_EQ(xor_of(view(bytes).part(from, size)), expected) << from << ' ' << size;
      expected = static_cast<std::uint8_t>(expected ^ bytes[from + size]);
    }
  }
}

}  // namespace
}  // namespace tocsin::kobuki
