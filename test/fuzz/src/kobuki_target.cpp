// SPDX-License-Identifier: Apache-2.0
#include "kobuki_target.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "kobuki_protocol/battery.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/events.hpp"
#include "kobuki_protocol/odometry.hpp"
#include "kobuki_protocol/reassembler.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::kobuki {
namespace {

void use_feedback(ByteView payload) {
  DecodeCounts counts;
  const Feedback feedback = decode_feedback(payload, counts);
  assert(!feedback.gyro || feedback.gyro->count <= RawGyro::max_samples);
  const Frame encoded = encode_feedback(feedback);
  const Feedback again = decode_feedback(encoded.payload(), counts);
  const Frame twice = encode_feedback(again);
  assert(std::equal(encoded.bytes().begin(), encoded.bytes().end(), twice.bytes().begin(),
                    twice.bytes().end()));
  EventDetector events{BatteryParams{}};
  assert(events.update(feedback).size() <= 16);
  if (!feedback.core) return;
  Odometry odometry{OdometryParams{}};
  odometry.update(CoreSensors{}, feedback.inertia);
  odometry.update(*feedback.core, feedback.inertia);
  assert(std::isfinite(odometry.pose().x_m) && std::isfinite(odometry.pose().heading_rad));
  const Battery battery =
      BatteryReader{BatteryParams{}}.read(feedback.core->battery_dv, feedback.core->charger);
  assert(battery.percentage >= 0 && battery.percentage <= 1);
}

void use_commands(ByteView payload) {
  DecodeCounts counts;
  decode_commands(payload, counts, [](const Command& command) {
    const Frame frame = encode_command(command);
    assert(xor_of(frame.bytes().part(2, frame.bytes().size - 2)) == 0);
    if (const auto* control = std::get_if<BaseControl>(&command)) {
      const BaseControl sent = encode_velocity(body_velocity(decode_velocity(*control)));
      assert(sent.radius_mm != -1);
    }
  });
}

void use(ByteView payload) {
  use_feedback(payload);
  use_commands(payload);
}

/// Through the reassembler in portions of the size that the first byte says.
void feed(ByteView bytes) {
  Reassembler reassembler;
  const std::size_t portion = std::max<std::size_t>(1, bytes[0]);
  std::size_t in_frames = 0;
  for (std::size_t at = 1; at < bytes.size; at += portion) {
    const ByteView part = bytes.part(at, std::min(portion, bytes.size - at));
    reassembler.feed(part, [&](ByteView payload) {
      in_frames += payload.size + 4;
      use(payload);
    });
  }
  assert(in_frames + reassembler.counts().discarded + reassembler.pending() == bytes.size - 1);
}

}  // namespace
}  // namespace tocsin::kobuki

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  using tocsin::ByteView;
  tocsin::kobuki::feed({data, size});
  tocsin::kobuki::use({data, std::min<std::size_t>(size, 255)});  // decoders without a checksum
  return 0;
}
