// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "../src/rplidar_target.hpp"
#include "rplidar_protocol/answer.hpp"

namespace tocsin::rplidar {
namespace {

void append(Bytes& stream, const Bytes& part) {
  stream.insert(stream.end(), part.begin(), part.end());
}

/// What a device sends after a question and in a scan of either kind.
Bytes good_stream(std::mt19937& random) {
  Bytes stream{static_cast<std::uint8_t>(random())};
  append(stream, descriptor(AnswerType::health));
  append(stream, encode(Health{}));
  const bool is_express = random() % 2 == 0;
  append(stream, descriptor(is_express ? AnswerType::express : AnswerType::scan));
  std::array<double, capsule_readings> ranges_m{};
  for (double& range_m : ranges_m) range_m = 0.001 * static_cast<double>(random() % 16384);
  for (int i = 0; i < 8; ++i) {
    const double angle_rad = 0.1 * i;
    if (is_express)
      append(stream, encode_capsule(angle_rad, ranges_m, i == 0));
    else
      append(stream, encode(Reading{angle_rad, ranges_m[0], 12, i == 0}));
  }
  return stream;
}

void mutate(Bytes& bytes, std::mt19937& random) {
  for (unsigned i = random() % 8; i > 0 && !bytes.empty(); --i) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
    const unsigned kind = random() % 4;
    if (kind == 0) *at = static_cast<std::uint8_t>(random());
    if (kind == 1) bytes.erase(at);
    if (kind == 2) bytes.insert(at, static_cast<std::uint8_t>(random()));
    if (kind == 3) *at = random() % 2 == 0 ? 0xA5 : 0x5A;
  }
}

TEST(RplidarFuzz, SurvivesMutatedAnswers) {
  std::mt19937 random(20261126);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes = good_stream(random);
    mutate(bytes, random);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}

TEST(RplidarFuzz, SurvivesNoise) {
  std::mt19937 random(43);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes(random() % 600);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}

}  // namespace
}  // namespace tocsin::rplidar
