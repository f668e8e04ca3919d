// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::uint32_t fragment_bytes = 16;

/// A sample as DATA_FRAGs, one a message.
std::vector<Bytes> fragments_of(const Bytes& payload, std::uint32_t writer,
                                std::int64_t number = 1) {
  std::vector<Bytes> messages;
  std::uint32_t at = 1;
  for (std::size_t begin = 0; begin < payload.size(); begin += fragment_bytes, ++at) {
    const std::size_t end = std::min(begin + fragment_bytes, payload.size());
    Wire content = data_head(writer, number, 28);
    content.u32(at).u16(1).u16(fragment_bytes).u32(static_cast<std::uint32_t>(payload.size()));
    for (std::size_t i = begin; i < end; ++i) content.u8(payload[i]);
    messages.push_back(Message('a').add(0x16, 0, content.bytes()).bytes());
  }
  return messages;
}

Bytes participant(const Wire& more = {}, char name = 'a') {
  return parameters_payload(Wire().parameter(0x50, guid_of(name)).raw(more.bytes()).sentinel());
}

/// What a filter says of the last of these; it drops none before.
Inspection last_of(RtpsFilter& sut, const std::vector<Bytes>& messages) {
  Inspection inspection;
  for (const Bytes& message : messages) {
    EXPECT_EQ(inspection.drop, passes);
    EXPECT_TRUE(inspection.before.empty());
    inspection = inspect(sut, message);
  }
  return inspection;
}

TEST(Fragments, OfAnAnnouncementAreHiddenUntilItIsWhole) {
  RtpsFilter sut{Limits{}};
  const Bytes payload = participant(Wire().parameter(0x62, Wire().text("a long name").bytes()));
  const auto messages = fragments_of(payload, spdp_writer);
  ASSERT_GT(messages.size(), 1U);
  const Inspection first = inspect(sut, messages[0]);
  EXPECT_EQ(first.drop, passes);
  ASSERT_EQ(first.hide.size(), 1U);
  EXPECT_EQ(messages[0][first.hide[0]], 0x16);
  EXPECT_TRUE(first.before.empty());
  EXPECT_EQ(sut.participants(), 0U);
  const Inspection last = last_of(sut, messages);
  Bytes expected = data_of(data_head(spdp_writer).raw(payload));
  expected[22] = expected[23] = 0;  // its length: until the end
  EXPECT_EQ(last.before, std::vector<Bytes>{expected});
  EXPECT_EQ(last.hide.size(), 1U);
  EXPECT_EQ(sut.participants(), 1U);
}

TEST(Fragments, MayComeInAnyOrderAndTwice) {
  RtpsFilter sut{Limits{}};
  auto messages = fragments_of(participant(), spdp_writer);
  std::reverse(messages.begin(), messages.end());
  messages.insert(messages.begin(), messages.front());
  EXPECT_FALSE(last_of(sut, messages).before.empty());
}

TEST(Fragments, OfUserDataPassAsTheyAre) {
  RtpsFilter sut{Limits{}};
  for (const Bytes& message : fragments_of(Bytes(200, 0), user_writer)) {
    const Inspection inspection = inspect(sut, message);
    EXPECT_EQ(inspection.drop, passes);
    EXPECT_TRUE(inspection.hide.empty());
  }
}

TEST(Fragments, HideNothingFromTheFilter) {
  RtpsFilter sut{Limits{}};
  const Wire token = Wire().parameter(0x1001, Wire().text("DDS").u32(0xffffffff).bytes());
  EXPECT_EQ(last_of(sut, fragments_of(participant(token), spdp_writer)).drop,
            DropReason::security_content);
  EXPECT_EQ(last_of(sut, fragments_of(participant({}, 'b'), spdp_writer)).drop,
            DropReason::foreign_identity);
}

TEST(Fragments, OfAKeyAreAKey) {
  constexpr std::uint32_t key_of_fragment = 4;
  const Wire qos = Wire().parameter(0x71, {0, 0, 0, 1}).sentinel();
  const Wire content = data_head(spdp_writer, 2, 28)
                           .u32(1)
                           .u16(1)
                           .u16(16)
                           .u32(16)
                           .raw(qos.bytes())
                           .raw(guid_of('a'));
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  const auto disposed_by = [&](char name) {
    return drop_of(sut,
                   Message(name).add(0x16, with_qos | key_of_fragment, content.bytes()).bytes());
  };
  EXPECT_EQ(disposed_by('m'), DropReason::foreign_identity);
}

TEST(Fragments, OfAuthenticationAreLookedAtToo) {
  constexpr std::uint32_t stateless_writer = 0x000201c3;
  const Wire head = Wire().raw({0, 1, 0, 0}).zeros(24 + 24 + 48).text("dds.sec.auth");
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(last_of(sut, fragments_of(Wire(head).u32(0).bytes(), stateless_writer)).drop, passes);
  EXPECT_EQ(last_of(sut, fragments_of(Wire(head).u32(0xffffffff).bytes(), stateless_writer)).drop,
            DropReason::security_content);
}

TEST(Fragments, WholeIsWithoutWhatMustNotBeRead) {
  Limits limits;
  limits.answers = [](std::uint32_t) { return false; };
  RtpsFilter sut(limits);
  const Wire list = Wire().parameter(0x32, locator(ipv4(203, 0, 113, 9)));
  const Inspection last = last_of(sut, fragments_of(participant(list), spdp_writer));
  EXPECT_EQ(last.drop, passes);
  constexpr std::size_t locator_at = 20 + 4 + 20 + 4 + 20;
  ASSERT_EQ(last.before.size(), 1U);
  EXPECT_EQ(last.before[0].at(locator_at), 0);
}

TEST(Fragments, WholeIsForWhomTheFragmentsWere) {
  RtpsFilter sut{Limits{}};
  const Bytes payload = participant();
  const auto size = static_cast<std::uint32_t>(payload.size());
  const Wire content = data_head(spdp_writer, 1, 28).u32(1).u16(1).u16(size).u32(size).raw(payload);
  const Bytes message =
      Message('a').add(0x0e, 0, prefix_of('z')).add(0x16, 0, content.bytes()).bytes();
  const Inspection inspection = inspect(sut, message);
  const Bytes destination = Message('a').add(0x0e, 0, prefix_of('z')).bytes();
  ASSERT_EQ(inspection.before.size(), 1U);
  EXPECT_TRUE(std::equal(destination.begin(), destination.end(), inspection.before[0].begin()));
}

TEST(Fragments, OfTheOldestOfManySamplesAreForgotten) {
  RtpsFilter sut{Limits{}};
  const auto first = fragments_of(participant(), spdp_writer);
  (void)inspect(sut, first[0]);
  for (std::int64_t number = 2; number <= 65; ++number) {
    (void)inspect(sut, fragments_of(participant(), spdp_writer, number)[0]);
  }
  EXPECT_TRUE(inspect(sut, first[1]).before.empty());
  EXPECT_FALSE(inspect(sut, first[0]).before.empty());
}

TEST(Fragments, OfAnotherShapeBeginASampleAnew) {
  RtpsFilter sut{Limits{}};
  const auto shorter = fragments_of(participant(), spdp_writer);
  const Wire name = Wire().parameter(0x62, Wire().text("a name of some length").bytes());
  (void)inspect(sut, fragments_of(participant(name), spdp_writer)[0]);
  EXPECT_FALSE(last_of(sut, shorter).before.empty());
}

Bytes endpoint(std::uint32_t token = 0) {
  const Wire text = Wire().parameter(0x05, Wire().text("a topic's name").bytes());
  const Wire odd = token == 0 ? text : Wire().parameter(0x73, Wire().u32(token).bytes());
  return parameters_payload(
      Wire().parameter(0x5a, guid_of('a', user_writer)).raw(odd.bytes()).sentinel());
}

TEST(Fragments, OfAnEndpointAreShownButTheLast) {
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  const auto messages = fragments_of(endpoint(), sedp_writer);
  ASSERT_GT(messages.size(), 2U);
  EXPECT_TRUE(inspect(sut, messages[0]).hide.empty());
  const Inspection last = last_of(sut, messages);
  EXPECT_EQ(last.hide.size(), 1U);
  const auto size = static_cast<std::uint32_t>(endpoint().size());
  const Wire content = data_head(sedp_writer, 1, 28)
                           .u32(1)
                           .u16((size + fragment_bytes - 1) / fragment_bytes)
                           .u16(fragment_bytes)
                           .u32(size)
                           .raw(endpoint());
  Bytes expected = Message('a').add(0x16, 0, content.bytes()).bytes();
  expected[22] = expected[23] = 0;
  EXPECT_EQ(last.before, std::vector<Bytes>{expected});
}

TEST(Fragments, OfAnEndpointOfAStrangerAreHidden) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(inspect(sut, fragments_of(endpoint(), sedp_writer)[0]).hide.size(), 1U);
}

TEST(Fragments, ThatWereShownAreNeverCompletedUnlookedAt) {
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  const auto bad = fragments_of(endpoint(0xffffffff), sedp_writer);
  EXPECT_EQ(last_of(sut, bad).drop, DropReason::parameter_content);
  for (std::int64_t number = 2; number <= 100; ++number) {  // others do not make it forgotten
    (void)inspect(sut, fragments_of(endpoint(), sedp_writer, number)[0]);
  }
  const Inspection again = inspect(sut, bad.back());
  EXPECT_TRUE(again.drop || again.hide.size() == 1);
  EXPECT_TRUE(again.before.empty());
}

TEST(Fragments, OfSamplesThatAreManyAtOnceAreHidden) {
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  for (std::int64_t number = 1; number <= 64; ++number) {
    EXPECT_TRUE(inspect(sut, fragments_of(endpoint(), sedp_writer, number)[0]).hide.empty());
  }
  EXPECT_EQ(inspect(sut, fragments_of(endpoint(), sedp_writer, 65)[0]).hide.size(), 1U);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
}

}  // namespace
}  // namespace tocsin::rtps_filter
