// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "advice.hpp"

namespace tocsin::doctor {

/// The text of a file below /proc/sys; empty when it cannot be read.
using ReadSysctl = std::function<std::optional<std::string>(const std::string& name)>;

/// What the kernel's settings mean for the stack: socket buffers, echo requests without
/// privileges, which `root` does not need.
[[nodiscard]] Advices judge_limits(const ReadSysctl& read, bool root);

}  // namespace tocsin::doctor
