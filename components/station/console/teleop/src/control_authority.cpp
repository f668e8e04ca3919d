// SPDX-License-Identifier: Apache-2.0
#include "teleop/control_authority.hpp"

#include <unistd.h>

#include <array>

namespace tocsin {

std::optional<ControlVerb> handover_verb(const ControlAuthority& authority, const std::string& me) {
  if (authority.driver == me) {
    return authority.asked_by.empty() ? std::nullopt : std::optional(ControlVerb::give);
  }
  return authority.driver.empty() ? std::nullopt : std::optional(ControlVerb::ask);
}

std::string control_text(const ControlAuthority& authority, const std::string& me) {
  if (authority.driver == me) {
    return authority.asked_by.empty()
               ? ""
               : authority.asked_by + " asks for control: h gives, n keeps it";
  }
  if (authority.driver.empty()) return "";
  if (authority.asked_by == me) return authority.driver + " drives, and was asked for control";
  return authority.driver + " drives: h asks for control";
}

std::string operator_name(const std::string& name, const std::string& device) {
  if (!name.empty()) return name;
  std::array<char, 64> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  return device + "@" + host.data() + ":" + std::to_string(::getpid());
}

}  // namespace tocsin
