// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/rtps_message.hpp"

#include <gtest/gtest.h>

#include <random>

#include "link/rtps_bytes.hpp"
#include "rtps/origin.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

std::uint32_t sender(const Bytes& bytes) {
  const auto found = sender_in(bytes.data(), bytes.size());
  return found ? wire_id_of(*found) : 0;
}

std::size_t shortened(const Bytes& bytes) {
  return size_without_statistics(bytes.data(), bytes.size());
}

TEST(SizeWithoutStatistics, LeavesOutTheLastSubmessageOfFastDds) {
  Bytes bytes = message();
  append(bytes, data, data_of(7));
  const std::size_t without = bytes.size();
  append(bytes, of_vendor, Bytes(56), false);
  EXPECT_EQ(shortened(bytes), without);
  EXPECT_EQ(bytes.size(), without + 60);
}

TEST(SizeWithoutStatistics, LeavesAnythingElseAsItIs) {
  Bytes sample = message();
  append(sample, data, Bytes(100, of_vendor));
  EXPECT_EQ(shortened(sample), sample.size()) << "a sample of such bytes";
  Bytes other = message();
  append(other, of_vendor, Bytes(55));
  EXPECT_EQ(shortened(other), other.size()) << "another size";
  Bytes first = message();
  append(first, of_vendor, Bytes(56));
  append(first, data, data_of(7));
  EXPECT_EQ(shortened(first), first.size()) << "not the last";
  Bytes cut = message();
  append(cut, of_vendor, Bytes(56));
  cut.pop_back();
  EXPECT_EQ(shortened(cut), cut.size()) << "cut off";
  EXPECT_EQ(size_without_statistics(cut.data(), 0), 0U);
}

/// A message of authentication to `addressee` in a packet for `destination`.
Bytes authentication(std::uint8_t addressee, std::uint8_t destination,
                     const Bytes& writer = {0, 2, 1, 0xc3}) {
  Bytes bytes = message();
  append(bytes, info_destination, Bytes(12, destination));
  Bytes content{0, 0, 16, 0, 0, 2, 1, 0xc4};
  content.insert(content.end(), writer.begin(), writer.end());
  content.resize(content.size() + 8 + 4 + 48);  // number, encapsulation, two identities
  content.resize(content.size() + 12, addressee);
  content.resize(content.size() + 4 + 32);
  append(bytes, data, content);
  return bytes;
}

/// A message that is sealed with the key of this identifier.
Bytes sealed(const Bytes& key) {
  Bytes bytes = message();
  append(bytes, info_destination, Bytes(12, 7));
  Bytes content{0, 0, 0, 2};  // AES-256 in GCM
  content.insert(content.end(), key.begin(), key.end());
  content.resize(20);
  append(bytes, 0x31, content);
  return bytes;
}

bool exchanges_keys(const Bytes& bytes) { return is_key_exchange(bytes.data(), bytes.size()); }

TEST(IsKeyExchange, IsWhatIsSealedWithTheKeyOfTheHandshake) {
  EXPECT_TRUE(exchanges_keys(sealed({0, 0, 0, 0})));
  EXPECT_FALSE(exchanges_keys(sealed({0, 0, 0, 1})));
  EXPECT_FALSE(exchanges_keys(authentication(7, 7)));
  Bytes cut = message();
  append(cut, 0x31, Bytes(7));
  EXPECT_FALSE(exchanges_keys(cut));
  EXPECT_FALSE(exchanges_keys({}));
}

std::optional<Authentication> read_authentication(const Bytes& bytes) {
  return authentication_in(bytes.data(), bytes.size());
}

TEST(AuthenticationIn, TellsWhetherThePacketIsForItsAddressee) {
  for (const std::uint8_t destination : std::vector<std::uint8_t>{7, 8}) {
    const auto found = read_authentication(authentication(7, destination));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->addressee.value[0], 7);
    EXPECT_EQ(found->goes_elsewhere, destination == 8);
  }
  EXPECT_FALSE(read_authentication(authentication(7, 8, {0, 0, 7, 3}))) << "another message";
  EXPECT_FALSE(read_authentication({}));
  Bytes cut = message();
  append(cut, info_destination, Bytes(12, 8));
  append(cut, data, {0, 0, 16, 0, 0, 2, 1, 0xc4, 0, 2, 1, 0xc3, 0, 0, 0, 0});
  EXPECT_FALSE(read_authentication(cut));
}

/// A message of these submessages.
struct Part {
  std::uint8_t kind;
  Bytes content;
  bool little_endian = true;
};
Bytes of(const std::vector<Part>& parts) {
  Bytes bytes = message();
  for (const auto& [kind, content, little] : parts) append(bytes, kind, content, little);
  return bytes;
}

TEST(SenderIn, IsTheWriterOfDataAndHeartbeatsTheReaderOfAcknacksBehindWhateverNamesNobody) {
  const Part sample{data, data_of(7)};
  for (const auto& [bytes, expected] : std::vector<std::pair<Bytes, std::uint32_t>>{
           {of({sample}), 0x0703},
           {of({{fragment, data_of(7)}}), 0x0703},
           {of({{heartbeat, ends(5, 9)}}), 0x0903},
           {of({{acknack, ends(5, 9)}}), 0x0504},
           {of({{info_timestamp, Bytes(8)}, sample}), 0x0703},
           {of({{info_timestamp, Bytes(8), false}, {data, data_of(7), false}}), 0x0703},
           {of({{info_timestamp, {}}, sample}), 0x0703},  // taken back
           {of({{0x01, {}}, sample}), 0x0703},            // PAD
           {{}, 0},
           {message(), 0},
           {of({{info_timestamp, {}}}), 0}}) {  // length 0: until the end
    EXPECT_EQ(sender(bytes), expected);
  }
  Bytes lies = of({sample});
  lies[20 + 2] = 0xff;
  EXPECT_EQ(sender(lies), 0U);
  Bytes cut = of({sample});
  cut.resize(20 + 4 + 11);
  EXPECT_EQ(sender(cut), 0U);
}

TEST(SenderIn, NeverReadsBeyondItsBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes(random() % 80);  // its own piece of memory: a sanitizer sees a read behind it
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 32);
    (void)sender_in(bytes.data(), bytes.size());
  }
}

/// Reader and writer of SEDP's publications, and something behind.
const Bytes builtin_ends{0, 0, 3, 0xc7, 0, 0, 3, 0xc2, 0, 0, 0, 0};

std::optional<StateKey> state_in(const Bytes& bytes) {
  return discovery_state_in(bytes.data(), bytes.size());
}

Bytes lone(std::uint8_t kind, std::uint8_t to = 1) {
  Bytes bytes = message();
  append(bytes, info_destination, Bytes(12, to));
  append(bytes, kind, builtin_ends);
  append(bytes, of_vendor, Bytes(8));
  return bytes;
}

TEST(IsAnnouncement, IsDataOfTheWriterOfAnnouncementsAndNothingElse) {
  Bytes announcement = message();
  append(announcement, info_timestamp, Bytes(8));
  Bytes content = data_of(0);
  std::copy_n(rtps::c_EntityId_SPDPWriter.value, 4, content.begin() + 8);
  append(announcement, data, content);
  EXPECT_TRUE(is_announcement(announcement.data(), announcement.size()));
  Bytes sample = message();
  append(sample, data, data_of(7));
  EXPECT_FALSE(is_announcement(sample.data(), sample.size()));
  EXPECT_FALSE(is_announcement(sample.data(), 0));
}

TEST(DiscoveryStateIn, KnowsAHeartbeatOrAnAcknowledgementOfDiscoveryByItsEndsAndItsParticipant) {
  const auto state = state_in(lone(heartbeat));
  ASSERT_TRUE(state);
  EXPECT_EQ(state, state_in(lone(heartbeat)));
  EXPECT_NE(state, state_in(lone(heartbeat, 2)));
  EXPECT_TRUE(state_in(lone(acknack)));
  EXPECT_NE(state, state_in(lone(acknack)));
}

TEST(DiscoveryStateIn, IsNotInAMessageThatCarriesMore) {
  Bytes announcement = message();
  append(announcement, data, data_of(0xc2));
  append(announcement, heartbeat, builtin_ends);
  EXPECT_FALSE(state_in(announcement));
  Bytes two = lone(acknack);
  append(two, acknack, builtin_ends);
  EXPECT_FALSE(state_in(two));
  EXPECT_FALSE(state_in(message()));
  Bytes of_a_topic = message();
  append(of_a_topic, heartbeat, ends(5, 9));
  EXPECT_FALSE(state_in(of_a_topic));
}

TEST(DiscoveryStateIn, NeverReadsBeyondItsBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes = lone(random() % 2 == 0 ? acknack : heartbeat);
    bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % (bytes.size() + 1));
    bytes.shrink_to_fit();
    (void)state_in(bytes);
  }
}

}  // namespace
}  // namespace tocsin
