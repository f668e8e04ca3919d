// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "rtps_filter/rtps_filter.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::rtps_filter;

Limits tight_limits() {
  Limits limits;
  limits.participants = 3;
  limits.endpoints = 5;
  limits.sources = 2;
  limits.participant_has_address = true;
  limits.answers = [](std::uint32_t address) { return address >> 24U == 127; };
  return limits;
}

/// A parameter that is to be stripped lies behind both headers, and is one that may be.
void check_strips(const std::uint8_t* packet, std::size_t size, const Inspection& inspection) {
  constexpr std::size_t headers = 20 + 4 + 20;
  for (const std::size_t at : inspection.strip) {
    assert(at >= headers && at + 4 <= size);
    assert(packet[at] != 0 || packet[at + 1] != 0);
  }
}

/// Numbers that are told smaller than they are, and that lie in the packet.
void check_steps(const std::uint8_t* packet, std::size_t size, const Inspection& inspection) {
  constexpr std::size_t before = 20 + 4 + 8;
  for (const auto& step : inspection.step) {
    assert(step.at >= before && step.at + step.size + 4 <= size);
    assert(!std::equal(step.bytes.begin(), step.bytes.begin() + step.size, packet + step.at));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Limits limits = tight_limits();
  RtpsFilter sut(limits);
  Time now = Time{} + std::chrono::hours(1);
  std::size_t at = 0;
  while (at + 2 <= size) {
    const std::size_t wanted = data[at] | static_cast<std::size_t>(data[at + 1]) << 8U;
    const std::size_t length = std::min(wanted, size - at - 2);
    const std::uint8_t* packet = data + at + 2;
    const Source from{ipv4(127, 0, 0, 1), static_cast<std::uint16_t>(length % 3)};
    const auto sender = length % 16 == 15 ? Sender::gone : Sender::trusted;
    const Inspection inspection = sut.inspect(packet, length, from, now, sender);
    if (!inspection.drop) {
      check_strips(packet, length, inspection);
      check_steps(packet, length, inspection);
    }
    assert(inspection.drop || length >= 20);
    assert(sut.participants() <= limits.participants);
    now += std::chrono::milliseconds(100);
    at += 2 + length;
  }
  return 0;
}
