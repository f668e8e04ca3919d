// SPDX-License-Identifier: Apache-2.0
#include "rplidar_target.hpp"

#include <algorithm>
#include <cassert>

#include "foundation/numbers.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::rplidar {
namespace {

void check(const Reading& reading) {
  assert(reading.angle_rad >= 0 && reading.angle_rad < 2 * pi);
  assert(reading.range_m >= 0 && reading.range_m < 16.4);
  assert(reading.quality >= 0 && reading.quality <= 63);
}

void feed(ByteView bytes) {
  Decoder decoder;
  std::uint64_t readings = 0;
  const std::size_t portion = std::max<std::size_t>(1, bytes[0]);
  for (std::size_t at = 1; at < bytes.size; at += portion) {
    decoder.feed(bytes.part(at, std::min(portion, bytes.size - at)), [&](const Answer& answer) {
      if (const auto* reading = std::get_if<Reading>(&answer)) {
        check(*reading);
        ++readings;
      }
    });
  }
  assert(readings == decoder.counts().readings);
  assert(decoder.counts().discarded < bytes.size);
}

}  // namespace
}  // namespace tocsin::rplidar

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) tocsin::rplidar::feed({data, size});
  return 0;
}
