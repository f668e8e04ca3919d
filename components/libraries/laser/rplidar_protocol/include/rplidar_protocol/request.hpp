// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/bytes.hpp"

namespace tocsin::rplidar {

using Bytes = std::vector<std::uint8_t>;

/// What a computer asks of an RPLIDAR (Slamtec, "RPLIDAR Interface Protocol and Application Notes",
/// v2.8, chapter 4). Any request but the motor's ends a scan.
enum class Command : std::uint8_t {
  scan = 0x20,           ///< answered without end, a reading at a time
  stop = 0x25,           ///< no answer; the device is ready again after 1 ms
  reset = 0x40,          ///< no answer but a greeting in ASCII; ready again after 2 ms to 2 s
  get_info = 0x50,       ///< answered by Info
  get_health = 0x52,     ///< answered by Health
  express_scan = 0x82,   ///< answered without end, 32 readings a capsule, at twice the rate
  set_motor_pwm = 0xF0,  ///< no answer; A2 only, the motor of an A1 turns while DTR is cleared
};

/// The bytes of a request without payload, and of express_scan in its oldest form.
[[nodiscard]] Bytes request(Command command);
/// `duty` of the motor [range 0,1023]; 0 stops it, 660 is Slamtec's default.
[[nodiscard]] Bytes motor_request(std::uint16_t duty);

/// A request as a device receives it.
struct Request {
  Command command = Command::stop;
  std::uint16_t motor_duty = 0;  ///< of set_motor_pwm
};

/// Finds requests in a byte stream, however it is cut. What is no request of the list, and a
/// payload whose checksum is wrong, is passed over.
class RequestReader {
 public:
  void add(ByteView bytes) { buffer_.insert(buffer_.end(), bytes.begin(), bytes.end()); }
  /// The next one; empty when there is none yet.
  [[nodiscard]] std::optional<Request> next();

 private:
  Bytes buffer_;
};

}  // namespace tocsin::rplidar
