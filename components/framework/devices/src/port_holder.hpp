// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// "name (pid 123)" of another process that has the file open; empty when we can see none.
[[nodiscard]] std::optional<std::string> holder_of(const std::string& path);

}  // namespace tocsin
