// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/authentication_repeats.hpp"

#include <gtest/gtest.h>

#include "fast_dds_v2/message_pieces.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using Packet = AuthenticationRepeats::Packet;

constexpr Time t0{std::chrono::seconds(1000)};

AuthenticationRepeats::Participant participant(std::uint8_t name) {
  AuthenticationRepeats::Participant prefix;
  std::fill_n(prefix.value, prefix.size, name);
  return prefix;
}

/// Pieces of the messages of one participant.
class Sender {
 public:
  explicit Sender(std::uint8_t name) : message_{'R', 'T', 'P', 'S', 2, 3, 1, 15} {
    message_.resize(20, name);
    message_.resize(4000);
  }
  Packet next() { return pieces_.of(message_.data(), message_.size()).front(); }

 private:
  Packet message_;
  MessagePieces pieces_;
};

class AuthenticationRepeatsTest : public ::testing::Test {
 protected:
  void send(std::uint8_t to) { sut_.sent(participant(to), {{{to}}, {}}, t0); }
  void receive(const Packet& packet) { sut_.on_packet(packet.data(), packet.size()); }
  [[nodiscard]] bool is_due(Time now) { return sut_.take_due(now).has_value(); }
  AuthenticationRepeats sut_;
};

TEST_F(AuthenticationRepeatsTest, AMessageIsSentAgainAfterPausesThatDouble) {
  send(7);
  Time now = t0;
  for (const int pause_ms : {50, 100, 200, 400, 800}) {
    EXPECT_EQ(sut_.deadline(), now + milliseconds(pause_ms));
    EXPECT_FALSE(is_due(now + milliseconds(pause_ms - 1)));
    now += milliseconds(pause_ms);
    const auto due = sut_.take_due(now);
    ASSERT_TRUE(due);
    EXPECT_EQ(due->packets, std::vector<Packet>{{7}});
  }
  EXPECT_EQ(sut_.deadline(), never);
}

TEST_F(AuthenticationRepeatsTest, TheAddresseesAnswerEndsIt) {
  Sender addressee(7);
  send(7);
  receive(addressee.next());
  EXPECT_FALSE(is_due(t0 + milliseconds(50)));
}

TEST_F(AuthenticationRepeatsTest, WhatTheAddresseeRepeatsIsNoAnswer) {
  Sender addressee(7);
  const Packet request = addressee.next();
  receive(request);
  send(7);
  receive(request);
  EXPECT_TRUE(is_due(t0 + milliseconds(50)));
  receive(addressee.next());
  EXPECT_FALSE(is_due(t0 + milliseconds(150)));
}

TEST_F(AuthenticationRepeatsTest, AnotherParticipantsMessageIsNoAnswer) {
  send(7);
  receive(Sender(8).next());
  receive({});
  EXPECT_TRUE(is_due(t0 + milliseconds(50)));
}

TEST_F(AuthenticationRepeatsTest, ANextMessageTakesTheFormersPlace) {
  send(7);
  send(7);
  EXPECT_TRUE(is_due(t0 + milliseconds(50)));
  EXPECT_FALSE(is_due(t0 + milliseconds(50)));
}

TEST_F(AuthenticationRepeatsTest, MessagesToManyStrangersAreNotAllRepeated) {
  for (std::uint8_t to = 1; to <= 100; ++to) send(to);
  std::size_t repeated = 0;
  while (is_due(t0 + milliseconds(50))) ++repeated;
  EXPECT_EQ(repeated, AuthenticationRepeats::most_messages);
}

}  // namespace
}  // namespace tocsin
