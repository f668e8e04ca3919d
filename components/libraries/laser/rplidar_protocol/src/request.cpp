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

/// Of what may be a request; 1 when its second byte is none of the list.
std::size_t size_at_front(const Bytes& bytes) {
  const auto command = static_cast<Command>(bytes[1]);
  if (std::find(commands.begin(), commands.end(), command) == commands.end()) return 1;
  return (bytes[1] & has_payload) != 0 ? 4 + payload_size(command) : 2;
}

/// Empty for one byte, and when the checksum of a payload is wrong.
std::optional<Request> request_in(const Bytes& bytes) {
  if (bytes.size() < 2) return std::nullopt;
  Request request{static_cast<Command>(bytes[1]), 0};
  if (bytes.size() == 2) return request;
  const Bytes payload(bytes.begin() + 3, bytes.end() - 1);
  if (bytes != with_payload(request.command, payload)) return std::nullopt;
  request.motor_duty = static_cast<std::uint16_t>(payload[0] | payload[1] << 8);
  return request;
}

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
    const auto size = static_cast<std::ptrdiff_t>(size_at_front(buffer_));
    if (static_cast<std::ptrdiff_t>(buffer_.size()) < size) return std::nullopt;
    const auto found = request_in({buffer_.begin(), buffer_.begin() + size});
    buffer_.erase(buffer_.begin(), buffer_.begin() + (found ? size : 1));
    if (found) return found;
  }
}

}  // namespace tocsin::rplidar
