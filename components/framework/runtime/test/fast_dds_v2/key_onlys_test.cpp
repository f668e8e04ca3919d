// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/key_onlys.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "idl_support/key_only.hpp"

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t inline_qos_and_key = 0x0a;
const Bytes status_info{0x71, 0, 4, 0, 0, 0, 0, 3};
const Bytes alive{0x71, 0, 4, 0, 0, 0, 0, 0};
const Bytes sentinel{1, 0, 0, 0};
const Bytes topic{0, 0, 1, 2};

Bytes guid() {
  Bytes bytes(16);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  return bytes;
}

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Bytes key_hash() { return joined({{0x70, 0, 16, 0}, guid()}); }
Bytes header() { return {'R', 'T', 'P', 'S', 2, 1, 1, 16, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9}; }
Bytes timestamp() { return {9, 1, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8}; }
Bytes participants() { return {0, 1, 0, 0xc2}; }

/// What Cyclone DDS 0.10.2 sends when a participant or an end of it leaves.
Bytes departure(const Bytes& inline_qos, std::uint8_t flags = inline_qos_and_key,
                const Bytes& writer = participants(), std::uint8_t id = 0x50) {
  const Bytes ids = joined({{0, 0, 16, 0}, {0, 1, 0, 0xc7}, writer, {0, 0, 0, 0, 2, 0, 0, 0}});
  const Bytes key = joined({{0, 3, 0, 0}, {id, 0, 16, 0}, guid(), sentinel});
  const Bytes content = joined({ids, inline_qos, sentinel, key});
  const auto kind_and_flags = static_cast<std::uint8_t>(flags | 1);
  return joined({{0x15, kind_and_flags, static_cast<std::uint8_t>(content.size()), 0}, content});
}

Bytes told(const Bytes& message) {
  Bytes changed;
  const auto result = with_key_onlys(message.data(), message.size(), changed);
  return {result.first, result.first + result.second};
}

TEST(KeyOnlys, OfDiscoveryAKeyWithoutHashGetsItsGuidAsHash) {
  for (const auto id : {std::uint8_t{0x50}, std::uint8_t{0x5a}}) {
    const Bytes plain = departure(status_info, inline_qos_and_key, participants(), id);
    const Bytes hashed =
        departure(joined({status_info, key_hash()}), inline_qos_and_key, participants(), id);
    EXPECT_EQ(told(joined({header(), timestamp(), plain})),
              joined({header(), timestamp(), hashed}));
  }
}

TEST(KeyOnlys, EachDepartureOfAMessageGetsIts) {
  for (const Bytes& writer : {Bytes{0, 0, 3, 0xc2}, Bytes{0, 0, 4, 0xc2}}) {
    const Bytes plain = departure(status_info, inline_qos_and_key, writer);
    const Bytes hashed = departure(joined({status_info, key_hash()}), inline_qos_and_key, writer);
    EXPECT_EQ(told(joined({header(), plain, timestamp(), plain, timestamp()})),
              joined({header(), hashed, timestamp(), hashed, timestamp()}));
  }
}

TEST(KeyOnlys, ALengthOfZeroMeansTheRestOfTheMessageAndStaysSo) {
  Bytes plain = departure(status_info);
  Bytes hashed = departure(joined({status_info, key_hash()}));
  plain[2] = hashed[2] = 0;
  EXPECT_EQ(told(joined({header(), plain})), joined({header(), hashed}));
}

TEST(KeyOnlys, WhatHasAHashOrIsNoDepartureStaysAsItIs) {
  constexpr std::uint8_t inline_qos_and_data = 0x06;
  for (const Bytes& one :
       {departure(joined({key_hash(), status_info})), departure(status_info, inline_qos_and_data),
        departure(status_info, inline_qos_and_key, {0, 0, 1, 3}),  // of a topic without key
        departure(alive), departure(alive, inline_qos_and_key, topic), departure({}),
        departure(status_info, inline_qos_and_key, participants(), 0x15)}) {
    const Bytes message = joined({header(), one});
    EXPECT_EQ(told(message), message);
  }
}

/// A DATA that the key of a topic became.
Bytes as_data(Bytes departed, const Bytes& inline_qos) {
  constexpr std::size_t flags_at = 1;
  const std::size_t options_at = 4 + 20 + inline_qos.size() + sentinel.size() + 2;
  departed[flags_at] = 0x07;  // inline QoS and data, little endian
  departed[options_at] = key_only_options[0];
  departed[options_at + 1] = key_only_options[1];
  return departed;
}

TEST(KeyOnlys, OfATopicAKeyBecomesDataThatIsMarked) {
  for (const Bytes& inline_qos : {status_info, joined({status_info, key_hash()})}) {
    const Bytes plain = departure(inline_qos, inline_qos_and_key, topic);
    EXPECT_EQ(told(joined({header(), plain, timestamp()})),
              joined({header(), as_data(plain, inline_qos), timestamp()}));
  }
}

TEST(KeyOnlys, BehindADepartureThatGrewATopicsIsMarkedToo) {
  const Bytes grown = departure(joined({status_info, key_hash()}));
  const Bytes plain = departure(status_info, inline_qos_and_key, topic);
  EXPECT_EQ(told(joined({header(), departure(status_info), plain, plain})),
            joined({header(), grown, as_data(plain, status_info), as_data(plain, status_info)}));
}

TEST(KeyOnlys, WhatIsCutOffAnywhereStaysAsItIs) {
  const Bytes whole = joined({header(), departure(status_info)});
  for (std::size_t size = 0; size < whole.size() - sentinel.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_EQ(told(cut), cut) << size;
  }
}

}  // namespace
}  // namespace tocsin
