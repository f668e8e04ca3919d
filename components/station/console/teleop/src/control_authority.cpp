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

std::string control_text(const ControlAuthority& authority, const std::string& me,
                         const ControlKeys& keys) {
  const std::string take = keys.take.empty() ? "" : keys.take + " takes it";
  const std::string keep = keys.keep.empty() ? "" : ", " + keys.keep + " keeps it";
  if (authority.driver == me) {
    return authority.asked_by.empty()
               ? ""
               : authority.asked_by + " asks for control: " + keys.hand_over + " gives" + keep;
  }
  if (authority.driver.empty()) return "";
  if (authority.asked_by == me) {
    return authority.driver + " drives, and was asked for control" +
           (take.empty() ? "" : ": " + take);
  }
  return authority.driver + " drives: " + keys.hand_over + " asks for control" +
         (take.empty() ? "" : ", " + take);
}

std::string operator_name(const std::string& name, const std::string& device) {
  if (!name.empty()) return name;
  std::array<char, 64> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  return device + "@" + host.data() + ":" + std::to_string(::getpid());
}

}  // namespace tocsin
