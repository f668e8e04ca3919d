// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tocsin_idl/control_verb.hpp"

namespace tocsin {

/// Who drives the vehicle by hand and who asks to, as the vehicle reported last.
struct ControlAuthority {
  std::string driver;    ///< empty: nobody
  std::string asked_by;  ///< empty: nobody
};

/// What one key for all stands for: give control to who asks `me`, else ask who drives. Nothing
/// when there is nobody to ask or to give to.
[[nodiscard]] std::optional<ControlVerb> handover_verb(const ControlAuthority& authority,
                                                       const std::string& me);

/// What an operator presses on a device; empty: the device has none.
struct ControlKeys {
  std::string hand_over;  ///< for what handover_verb says
  std::string take;       ///< from who drives, unasked
  std::string keep;
};

/// What `me` has to know of it in a few words; empty: nothing.
[[nodiscard]] std::string control_text(const ControlAuthority& authority, const std::string& me,
                                       const ControlKeys& keys);

/// `name`, or when that is empty the device with this computer's name and this process, as
/// keyboard@gcs1:4711.
[[nodiscard]] std::string operator_name(const std::string& name, const std::string& device);

}  // namespace tocsin
