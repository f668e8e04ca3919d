// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

Wire lease(std::uint32_t lease_s) {
  return Wire().parameter(0x02, Wire().u32(lease_s).u32(0).bytes());
}

TEST(Participant, ThatSaysItselfThatItLeavesIsForgotten) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(sut.participants(), 1U);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(sut.participants(), 0U);
}

TEST(Participant, IsNotDisposedByAnotherSource) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), mallory), DropReason::forged_disposal);
  EXPECT_EQ(sut.participants(), 1U);
}

TEST(Participant, IsNotDisposedByAnotherParticipant) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('m', 'a'), mallory), DropReason::foreign_identity);
}

TEST(Participant, IsNotDisposedByASerializedKeyThatFastDdsTakesForAKeyHash) {
  const Wire qos = Wire().parameter(0x71, {0, 0, 0, 1}).sentinel();
  const Wire content = data_head(spdp_writer, 2).raw(qos.bytes()).raw(guid_of('a'));
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(
      drop_of(sut, Message('m').add(0x15, with_qos | with_key, content.bytes()).bytes(), mallory),
      DropReason::foreign_identity);
}

TEST(Participant, NobodyKnowsMayLeave) { EXPECT_EQ(drop_of(departure('a', 'a')), passes); }

TEST(Participant, IsNotAnnouncedByAnotherSourceOnceItsSocketsAreKnown) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), mallory, t0 + seconds(61)), DropReason::forged_source);
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0 + seconds(61)), passes);
}

TEST(Participant, MayHaveASocketForEachInterfaceAndGroup) {
  constexpr Source second{ipv4(192, 168, 7, 5), 40002};
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), second, t0 + seconds(60)), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), second, t0 + seconds(90)), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), second, t0 + seconds(90)), passes);
}

TEST(Participant, HasNotMoreThanEightSockets) {
  RtpsFilter sut{Limits{}};
  for (std::uint16_t port = 1; port <= 8; ++port) {
    EXPECT_EQ(drop_of(sut, announcement('a'), {alice.address, port}), passes);
  }
  EXPECT_EQ(drop_of(sut, announcement('a'), {alice.address, 9}), DropReason::forged_source);
}

TEST(Participant, SpeaksFromOneAddressWhereThatIsFixed) {
  constexpr Source other_port{alice.address, 40002};
  constexpr Source other_address{ipv4(10, 0, 0, 9), 40001};
  Limits limits;
  limits.participant_has_address = true;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_port), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_address), DropReason::forged_source);
  // Its lease is over, and Fast DDS has forgotten it.
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_address, t0 + seconds(11)), passes);
}

TEST(Participant, IsAdmittedWhileThereIsRoom) {
  Limits limits;
  limits.participants = 2;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b', lease(100))), passes);
  EXPECT_EQ(drop_of(sut, announcement('c')), DropReason::too_many_participants);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
}

TEST(Participant, WhoseLeaseIsOverMakesRoom) {
  Limits limits;
  limits.participants = 2;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b', lease(100))), passes);
  EXPECT_EQ(drop_of(sut, announcement('c'), alice, t0 + seconds(10)),
            DropReason::too_many_participants);
  EXPECT_EQ(drop_of(sut, announcement('c'), alice, t0 + seconds(11)), passes);
  EXPECT_EQ(sut.participants(), 2U);
}

TEST(Participant, ThatIsHeardKeepsItsPlace) {
  Limits limits;
  limits.participants = 1;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1), alice, t0 + seconds(8)), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), alice, t0 + seconds(15)),
            DropReason::too_many_participants);
}

TEST(Participant, WhoseLeaseIsForEverKeepsItsPlace) {
  Limits limits;
  limits.participants = 1;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(0x7fffffff))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), alice, t0 + std::chrono::hours(24)),
            DropReason::too_many_participants);
}

TEST(Participant, MayLeaveAndComeAgainFromAnotherSource) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), mallory), passes);
}

TEST(Endpoints, AreAdmittedWhileThereIsRoom) {
  Limits limits;
  limits.endpoints = 2;
  RtpsFilter sut(limits);
  const auto endpoint = [](std::uint32_t entity) {
    const Wire list = Wire().parameter(0x5a, guid_of('a', entity)).sentinel();
    return Message('a')
        .add(0x15, with_data, data_head(sedp_writer).raw(parameters_payload(list)).bytes())
        .bytes();
  };
  const auto gone = [](std::uint32_t entity) {
    const Wire qos =
        Wire().parameter(0x71, {0, 0, 0, 3}).parameter(0x70, guid_of('a', entity)).sentinel();
    return Message('a')
        .add(0x15, with_qos, data_head(sedp_writer).raw(qos.bytes()).bytes())
        .bytes();
  };
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, endpoint(1)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(2)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(2)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(3)), DropReason::too_many_endpoints);
  EXPECT_EQ(drop_of(sut, gone(1)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(3)), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, endpoint(4)), passes);
}

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
    EXPECT_EQ(number_at(&step.numbers[8]), number_at(step.numbers.data()) - 1);  // no sample
    return number_at(step.numbers.data());
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

  RtpsFilter sut = filter_of({1'000'000, 100});

  static RtpsFilter filter_of(Rate jumps) {
    Limits limits;
    limits.jump_step = 100;
    limits.jump_numbers = jumps;
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
  constexpr std::int64_t far = 0x0102030405;
  Bytes big = Message('a').bytes();
  const Bytes content = {0x07, 0, 0, 28, 0, 0, 0, 0, 0, 0, 1, 3,          // header, reader, writer
                         0,    0, 0, 1,  2, 3, 4, 5, 0, 0, 1, 2, 3, 4, 5, 6,  // first, last
                         0,    0, 0, 1};
  big.insert(big.end(), content.begin(), content.end());
  ASSERT_GT(far, 101);
  const Inspection inspection = inspect(sut, big);
  ASSERT_EQ(inspection.step.size(), 1U);
  const std::array<std::uint8_t, 16> wanted{0, 0, 0, 0, 0, 0, 0, 101, 0, 0, 0, 0, 0, 0, 0, 100};
  EXPECT_EQ(inspection.step[0].numbers, wanted);
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

TEST_F(Numbers, OfAllStepsAreLimitedBySecond) {
  sut = filter_of({150, 10});
  announce();
  EXPECT_EQ(told(next(500, 0x203)), 101);
  EXPECT_EQ(told(next(500, 0x303)), 0);
  EXPECT_EQ(told(next(51)), 51);  // a small one finds room
  EXPECT_EQ(told(next(500, 0x303), t0 + seconds(9)), 0);
  EXPECT_EQ(told(next(500, 0x303), t0 + seconds(10)), 101);
}

TEST_F(Numbers, BetweenSealsAreLeftAsTheyAre) {
  Limits limits;
  limits.jump_step = 100;
  limits.secured = true;
  RtpsFilter secured(limits);
  const Bytes content =
      Wire().entity(0).entity(user_writer).number(500).number(600).u32(1).bytes();
  const auto message = [&](bool sealed) {
    Message all('a');
    if (sealed) all.add(0x31, 0, Wire().zeros(20).bytes());
    all.add(0x07, 0, content);
    if (sealed) all.add(0x32, 0, Wire().zeros(20).bytes());
    return all.bytes();
  };
  EXPECT_EQ(inspect(secured, message(true)).step.size(), 0U);
  EXPECT_EQ(inspect(secured, message(false)).step.size(), 1U);
}

TEST(Steps, OfTheDefaultsAreSixteenAtOnce) {
  RtpsFilter sut{Limits{}};
  constexpr std::int64_t far = std::int64_t{1} << 40U;
  const Inspection inspection = inspect(sut, heartbeat('a', far, far));
  ASSERT_EQ(inspection.step.size(), 1U);
  for (int i = 0; i < 15; ++i) EXPECT_EQ(drop_of(sut, heartbeat('a', far, far)), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', far, far)), DropReason::sequence_jump);
}

TEST(Gaps, OfAParticipantAreLimitedBySecond) {
  Limits limits;
  limits.gap_rate = {1000, 10};
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 1001)), passes);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 2)), DropReason::gap_range);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 11), alice, t0 + seconds(1)), passes);
}

}  // namespace
}  // namespace tocsin::rtps_filter
