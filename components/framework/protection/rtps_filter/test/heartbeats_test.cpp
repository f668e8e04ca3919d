// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

/// A filter of steps of 100 numbers, with `a` and its writer announced.
class Numbers : public testing::Test {
 public:
  Numbers() {
    (void)inspect(sut, announcement('a'));
    announce();
  }
  void announce() { (void)inspect(sut, announcement('a', {}, sedp_writer)); }
  /// The first number that a HEARTBEAT tells behind the filter; zero: it is dropped.
  std::int64_t told(const Bytes& bytes, Time now = t0) {
    const Inspection inspection = inspect(sut, bytes, alice, now);
    if (inspection.drop) {
      EXPECT_EQ(*inspection.drop, DropReason::sequence_jump);
      return 0;
    }
    if (inspection.step.empty()) return number_at(bytes.data() + bytes.size() - 20);
    const auto& step = inspection.step.at(0);
    EXPECT_EQ(step.at, bytes.size() - 20);
    EXPECT_EQ(number_at(&step.bytes[8]), number_at(step.bytes.data()) - 1);  // no sample
    return number_at(step.bytes.data());
  }
  /// A HEARTBEAT of one of a's writers, of a count above those before; its last is far away.
  Bytes next(std::int64_t first, std::uint32_t writer = user_writer, std::uint32_t reader = 0) {
    return with_count(first, ++count_, writer, reader);
  }
  static Bytes with_count(std::int64_t first, std::uint32_t count,
                          std::uint32_t writer = user_writer, std::uint32_t reader = 0,
                          const std::string& destination = "") {
    Message message('a');
    if (!destination.empty()) message.add(0x0e, 0, prefix_of(destination[0]));
    const Wire content = Wire().entity(reader).entity(writer).number(first).number(first + 1000);
    return message.add(0x07, 0, Wire(content).u32(count).bytes()).bytes();
  }

  RtpsFilter sut = filter_of_small_steps();

  static RtpsFilter filter_of_small_steps() {
    Limits limits;
    limits.jump_step = 100;
    limits.jump_free = 50;
    limits.jump_cpu_s = {1, 0.1};
    return RtpsFilter(limits);
  }

 private:
  static std::int64_t number_at(const std::uint8_t* bytes) {
    std::uint64_t words[2];
    for (std::uint64_t& word : words) {
      word = std::uint64_t{bytes[0]} | std::uint64_t{bytes[1]} << 8U |
             std::uint64_t{bytes[2]} << 16U | std::uint64_t{bytes[3]} << 24U;
      bytes += 4;
    }
    return static_cast<std::int64_t>(words[0] << 32U | words[1]);
  }
  std::uint32_t count_ = 0;
};

TEST_F(Numbers, FarAheadAreToldStepByStep) {
  EXPECT_EQ(told(next(250)), 101);
  EXPECT_EQ(told(next(250)), 201);
  EXPECT_EQ(told(next(250)), 250);
  EXPECT_EQ(told(next(251)), 251);
}

TEST_F(Numbers, AreToldInTheByteOrderOfTheirSubmessage) {
  const Bytes to_far = {0x07, 0, 0, 28, 0, 0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 1,
                        0,    0, 0, 5,  0, 0, 0, 1, 0, 0, 0, 5, 0, 0, 0, 1};
  const Bytes message = Wire().raw(Message('a').bytes()).raw(to_far).bytes();
  const Inspection inspection = inspect(sut, message);
  ASSERT_EQ(inspection.step.size(), 1U);
  const std::array<std::uint8_t, 16> wanted{0, 0, 0, 0, 0, 0, 0, 101, 0, 0, 0, 0, 0, 0, 0, 100};
  EXPECT_EQ(inspection.step[0].bytes, wanted);
}

TEST_F(Numbers, OfEachWriterAndReaderAreTheirOwn) {
  EXPECT_EQ(told(next(101)), 101);
  EXPECT_EQ(told(next(201, user_writer, 0x107)), 101);
  EXPECT_EQ(told(next(201, user_writer, 0x107)), 201);
  EXPECT_EQ(told(next(201, 0x203)), 101);
  EXPECT_EQ(told(with_count(300, 1000, user_writer, 0, "b")), 101);
}

TEST_F(Numbers, AreNoProgressWhereTheReaderIgnoresTheCount) {
  EXPECT_EQ(told(with_count(300, 5)), 101);
  EXPECT_EQ(told(with_count(300, 5)), 201);  // this one is ignored
  EXPECT_EQ(told(with_count(300, 6)), 201);
  EXPECT_EQ(told(with_count(300, 7)), 300);
}

TEST_F(Numbers, BeginAnewWithAnAnnouncement) {
  EXPECT_EQ(told(next(101)), 101);
  announce();
  EXPECT_EQ(told(next(202)), 101);
}

TEST_F(Numbers, OfWritersThatNobodyAnnouncedAreNotRemembered) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(told(next(500, 0x203)), 101);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(told(next(500, sedp_writer)), 101);
  (void)inspect(sut, departure('a', 'a'));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(told(next(500)), 101);
}

TEST_F(Numbers, MayCostTheirTimeAndNoMore) {
  sut.took(std::chrono::milliseconds(999), t0);
  EXPECT_EQ(told(next(500)), 101);
  sut.took(std::chrono::milliseconds(301), t0);
  EXPECT_EQ(told(next(500)), 0);
  EXPECT_EQ(told(next(151)), 151);  // few cost nothing
  EXPECT_EQ(told(next(500), t0 + seconds(3)), 0);
  EXPECT_EQ(told(next(500), t0 + seconds(4)), 251);
}

TEST_F(Numbers, OfWhichThereAreManySayThatTheirCostIsWanted) {
  EXPECT_FALSE(inspect(sut, next(51)).jumps);
  EXPECT_TRUE(inspect(sut, next(102)).jumps);
  EXPECT_FALSE(inspect(sut, next(102)).jumps);
  EXPECT_TRUE(inspect(sut, next(52, 0x203)).jumps);  // nobody has announced it
}

TEST_F(Numbers, WithinAStepAreLeftAsTheyAre) {
  EXPECT_TRUE(inspect(sut, next(1)).step.empty());
  EXPECT_TRUE(inspect(sut, next(101)).step.empty());
  EXPECT_TRUE(inspect(sut, next(150)).step.empty());
  EXPECT_FALSE(inspect(sut, next(251)).step.empty());
}

TEST_F(Numbers, MayGoBack) {
  EXPECT_EQ(told(next(101)), 101);
  EXPECT_EQ(told(next(5)), 5);  // a repeated HEARTBEAT that was overtaken
  EXPECT_EQ(told(next(201)), 201);
}

TEST_F(Numbers, OfSeveralHeartbeatsInAPacketAreEachAStep) {
  const auto content = [](std::uint32_t count) {
    return Wire().entity(0).entity(user_writer).number(500).number(600).u32(count).bytes();
  };
  const Bytes message =
      Message('a')
          .add(0x07, 0, content(1))
          .add(0x15, with_data, data_head(user_writer, 600).raw(small_payload()).bytes())
          .add(0x07, 0, content(2))
          .bytes();
  const Inspection inspection = inspect(sut, message);
  EXPECT_EQ(inspection.drop, passes);
  ASSERT_EQ(inspection.step.size(), 2U);
  EXPECT_EQ(inspection.step[0].bytes[4], 101U);
  EXPECT_EQ(inspection.step[1].bytes[4], 201U);
  EXPECT_EQ(told(with_count(500, 3)), 301);
}

TEST_F(Numbers, OfSixteenReadersOfAWriterAreRemembered) {
  for (std::uint32_t reader = 1; reader <= 17; ++reader) {
    EXPECT_EQ(told(next(500, user_writer, reader << 8U)), 101) << reader;
  }
  for (std::uint32_t reader = 1; reader <= 16; ++reader) {
    EXPECT_EQ(told(next(500, user_writer, reader << 8U)), 201) << reader;
  }
  EXPECT_EQ(told(next(500, user_writer, 17U << 8U)), 101);  // begins from 1 each time
}

TEST_F(Numbers, BetweenSealsAreLeftAsTheyAre) {
  Limits limits;
  limits.jump_step = 100;
  limits.secured = true;
  RtpsFilter secured(limits);
  const Bytes content = Wire().entity(0).entity(user_writer).number(500).number(600).u32(1).bytes();
  const auto message = [&](bool sealed) {
    Message all('a');
    if (sealed) all.add(0x31, 0, Wire().zeros(20).bytes());
    all.add(0x07, 0, content);
    if (sealed) all.add(0x32, 0, Wire().zeros(20).bytes());
    return all.bytes();
  };
  EXPECT_EQ(inspect(secured, message(true)).step.size(), 0U);
  EXPECT_EQ(inspect(secured, message(false)).drop, DropReason::unsealed);
}

TEST(Steps, OfALongLivedWriterAreNotUsedUpByItsHeartbeats) {
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  constexpr std::uint32_t liveliness_writer = 0x000200c2;
  for (int i = 0; i < 1000; ++i) {
    const Inspection inspection = inspect(sut, heartbeat('a', 900'000, 900'000, liveliness_writer));
    EXPECT_EQ(inspection.drop, passes);
    EXPECT_TRUE(inspection.step.empty());
    sut.took(std::chrono::microseconds(5), t0);  // its reader has heard them
  }
}

}  // namespace
}  // namespace tocsin::rtps_filter
