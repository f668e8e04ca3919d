// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin::telemetry {

/// The whole of a small file; empty when it cannot be read.
[[nodiscard]] std::optional<std::string> read_text(const std::string& path);

}  // namespace tocsin::telemetry
