// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/device.hpp"

namespace tocsin {

/// What the kernel tells in files, as below /proc and /sys. Nothing throws.
class DeviceFiles : public Device {
 public:
  static constexpr const char* kind = "device files";
  /// The text of a file; empty when there is none or it is empty.
  [[nodiscard]] virtual std::optional<std::string> read(const std::string& /*path*/) {
    return std::nullopt;
  }
  /// The names in a folder, sorted; none when it is not there.
  [[nodiscard]] virtual std::vector<std::string> list(const std::string& /*folder*/) { return {}; }
};

}  // namespace tocsin
