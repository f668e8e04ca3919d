// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// Who drives the vehicle and who asks for its wheel, as the vehicle told last.
struct Wheel {
  std::string driver;    ///< empty: nobody
  std::string asked_by;  ///< empty: nobody
};

/// The verb of a request (tocsin_msgs/DriverRequest) that one key for all stands for: give it to
/// who asks me, else ask who drives. Nothing when there is nobody to ask or to give to.
[[nodiscard]] std::optional<std::string> handover_verb(const Wheel& wheel, const std::string& me);

/// What an operator has to know of it in a few words; empty when nothing is to be told.
[[nodiscard]] std::string wheel_text(const Wheel& wheel, const std::string& me);

/// `given`, or the device with this computer's name and this process: told from all others.
[[nodiscard]] std::string operator_name(const std::string& given, const std::string& device);

}  // namespace tocsin
