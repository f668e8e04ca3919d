// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "captures.hpp"
#include "fuzz_target.hpp"

namespace tocsin::rtps_filter {
namespace {

std::vector<Bytes> corpus() {
  std::vector<Bytes> packets;
  for (const char* vendor : {"fast_dds", "cyclone", "cyclone_fragments", "secured"}) {
    for (const Captured& packet : read_captures(vendor)) packets.push_back(packet.bytes);
  }
  packets.push_back(departure('a', 'a'));
  packets.push_back(heartbeat('a', 5, 9));
  packets.push_back(gap('a', 5, 9, 32));
  return packets;
}

/// Values at the edges of what lengths, counts and numbers may be.
std::uint8_t edge(std::mt19937& random) {
  constexpr std::uint8_t edges[] = {0x00, 0x01, 0x7f, 0x80, 0xfe, 0xff};
  return edges[random() % sizeof edges];
}

void mutate(Bytes& bytes, std::mt19937& random) {
  for (std::size_t i = 1 + random() % 6; i > 0 && bytes.size() > 4; --i) {
    const std::size_t at = random() % bytes.size();
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random() % 5) {
      case 0:
        *place = static_cast<std::uint8_t>(random());
        break;
      case 1:
        for (std::size_t n = 0; n < 4 && at + n < bytes.size(); ++n) bytes[at + n] = edge(random);
        break;
      case 2:
        bytes.erase(place, std::min(place + 4, bytes.end()));
        break;
      case 3:
        bytes.insert(place, random() % 9, edge(random));
        break;
      default:
        *place = static_cast<std::uint8_t>(*place ^ std::size_t{1} << random() % 8);
    }
  }
}

void append(Bytes& input, const Bytes& packet) {
  input.push_back(static_cast<std::uint8_t>(packet.size()));
  input.push_back(static_cast<std::uint8_t>(packet.size() >> 8U));
  input.insert(input.end(), packet.begin(), packet.end());
}

TEST(Fuzz, SurvivesMutatedCaptures) {
  constexpr unsigned seed = 20261122;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const std::vector<Bytes> good = corpus();
  for (int i = 0; i < 20000; ++i) {
    Bytes input;
    for (int n = 0; n < 3; ++n) {
      Bytes packet = good[random() % good.size()];
      if (n != 1) mutate(packet, random);
      append(input, packet);
    }
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
}

TEST(Fuzz, SurvivesNoiseBehindAHeader) {
  constexpr unsigned seed = 42;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 20000; ++i) {
    Bytes packet = i % 4 == 0 ? Bytes() : Message().bytes();
    for (std::size_t n = random() % 200; n > 0; --n) {
      packet.push_back(static_cast<std::uint8_t>(random() % (i % 2 == 0 ? 64 : 256)));
    }
    Bytes input;
    append(input, packet);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
}

}  // namespace
}  // namespace tocsin::rtps_filter
