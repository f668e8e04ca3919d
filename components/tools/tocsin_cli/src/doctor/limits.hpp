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

/// Whether the emulated radio can be made here: `tun_error` is the errno of opening /dev/net/tun,
/// 0 when that was possible; without `root` there must be user namespaces for everybody.
[[nodiscard]] Advices judge_radio(const ReadSysctl& read, bool root, int tun_error);

}  // namespace tocsin::doctor
