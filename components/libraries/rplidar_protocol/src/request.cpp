// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/request.hpp"

#include <algorithm>
#include <array>

namespace tocsin::rplidar {
namespace {

constexpr std::uint8_t start = 0xA5;
constexpr std::uint8_t has_payload = 0x80;  // bit of a command

constexpr std::array commands{Command::scan,         Command::stop,       Command::reset,
                              Command::get_info,     Command::get_health, Command::express_scan,
                              Command::set_motor_pwm};

Bytes with_payload(Command command, const Bytes& payload) {
  Bytes bytes(3 + payload.size());
  bytes[0] = start;
  bytes[1] = static_cast<std::uint8_t>(command);
  bytes[2] = static_cast<std::uint8_t>(payload.size());
  std::copy(payload.begin(), payload.end(), bytes.begin() + 3);
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : bytes) sum ^= byte;
  bytes.push_back(sum);
  return bytes;
}

std::size_t payload_size(Command command) { return command == Command::express_scan ? 5 : 2; }

}  // namespace

Bytes request(Command command) {
  if (command == Command::express_scan) return with_payload(command, Bytes(5, 0));
  return {start, static_cast<std::uint8_t>(command)};
}

Bytes motor_request(std::uint16_t duty) {
  return with_payload(Command::set_motor_pwm, {static_cast<std::uint8_t>(duty & 0xFFU),
                                               static_cast<std::uint8_t>(duty >> 8U)});
}

std::optional<Request> RequestReader::next() {
  while (true) {
    buffer_.erase(buffer_.begin(), std::find(buffer_.begin(), buffer_.end(), start));
    if (buffer_.size() < 2) return std::nullopt;
    const auto command = static_cast<Command>(buffer_[1]);
    const bool is_known = std::find(commands.begin(), commands.end(), command) != commands.end();
    const bool has_more = (buffer_[1] & has_payload) != 0;
    const std::size_t size = !is_known ? 1 : has_more ? 4 + payload_size(command) : 2;
    if (buffer_.size() < size) return std::nullopt;
    const Bytes bytes(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size));
    Request found{command, 0};
    if (is_known && has_more) {
      const Bytes payload(bytes.begin() + 3, bytes.end() - 1);
      if (bytes != with_payload(command, payload)) {
        buffer_.erase(buffer_.begin());
        continue;
      }
      found.motor_duty = static_cast<std::uint16_t>(payload[0] | payload[1] << 8);
    }
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size));
    if (is_known) return found;
  }
}

}  // namespace tocsin::rplidar
