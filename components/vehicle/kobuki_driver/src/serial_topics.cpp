// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/serial_topics.hpp"

#include <utility>

#include "kobuki_protocol/command.hpp"

namespace tocsin {
namespace {

std_msgs::msg::String hex(ByteView bytes) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  text.reserve(3 * bytes.size);
  for (const std::uint8_t byte : bytes) {
    text += digits[byte >> 4U];
    text += digits[byte & 0x0FU];
    text += ' ';
  }
  std_msgs::msg::String message;
  message.data(std::move(text));
  return message;
}

}  // namespace

SerialTopics::SerialTopics(Component& owner) : received_(owner), sent_(owner), control_(owner) {}

bool SerialTopics::received(ByteView bytes) {
  return received_.write(hex(bytes)) != Status::failed;
}

bool SerialTopics::sent(ByteView frame) {
  bool ok = sent_.write(hex(frame)) != Status::failed;
  kobuki::DecodeCounts counts;
  kobuki::decode_commands(frame.part(3, frame.size - 4), counts, [&](const auto& command) {
    const auto* control = std::get_if<kobuki::BaseControl>(&command);
    if (control == nullptr) return;
    std_msgs::msg::Int16MultiArray message;
    message.data({control->speed_mm_s, control->radius_mm});
    ok &= control_.write(std::move(message)) != Status::failed;
  });
  return ok;
}

}  // namespace tocsin
