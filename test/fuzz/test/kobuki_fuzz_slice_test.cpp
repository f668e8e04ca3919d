// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../src/kobuki_target.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Frames of a base and of a computer, one after the other.
Bytes good_stream(std::mt19937& random) {
  Feedback feedback;
  feedback.core = CoreSensors{};
  feedback.core->left_encoder = static_cast<std::uint16_t>(random());
  feedback.inertia = Inertia{};
  feedback.gyro = RawGyro{};
  feedback.gyro->count = static_cast<std::uint8_t>(random() % 9);
  feedback.firmware = Version{1, 2, 0, {}};
  feedback.input = GeneralInput{};
  Bytes stream{static_cast<std::uint8_t>(random())};
  for (const Frame& frame : {encode_feedback(feedback), encode_command(BaseControl{-1, -1}),
                             encode_command(SetGains{}), encode_feedback(feedback)}) {
    stream.insert(stream.end(), frame.bytes().begin(), frame.bytes().end());
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
    if (kind == 3) *at = random() % 2 == 0 ? 0xAA : 0x55;
  }
}

TEST(KobukiFuzz, SurvivesMutatedFrames) {
  std::mt19937 random(20261121);
  for (int i = 0; i < 100000; ++i) {
    Bytes bytes = good_stream(random);
    mutate(bytes, random);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}

TEST(KobukiFuzz, SurvivesNoise) {
  std::mt19937 random(42);
  for (int i = 0; i < 50000; ++i) {
    Bytes bytes(random() % 600);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % (i % 2 == 0 ? 32 : 256));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
}

}  // namespace
}  // namespace tocsin::kobuki
