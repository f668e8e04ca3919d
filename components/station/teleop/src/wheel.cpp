// SPDX-License-Identifier: Apache-2.0
#include "teleop_sender/wheel.hpp"

#include <unistd.h>

#include <array>

namespace tocsin {

std::optional<std::string> handover_verb(const Wheel& wheel, const std::string& me) {
  if (wheel.driver == me) return wheel.asked_by.empty() ? std::nullopt : std::optional("give");
  return wheel.driver.empty() ? std::nullopt : std::optional("ask");
}

std::string wheel_text(const Wheel& wheel, const std::string& me) {
  if (wheel.driver == me) {
    return wheel.asked_by.empty() ? ""
                                  : wheel.asked_by + " asks for the wheel: h gives, n keeps it";
  }
  if (wheel.driver.empty()) return "";
  if (wheel.asked_by == me) return wheel.driver + " drives, and was asked for the wheel";
  return wheel.driver + " drives: h asks for the wheel";
}

std::string operator_name(const std::string& given, const std::string& device) {
  if (!given.empty()) return given;
  std::array<char, 64> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  return device + "@" + host.data() + ":" + std::to_string(::getpid());
}

}  // namespace tocsin
