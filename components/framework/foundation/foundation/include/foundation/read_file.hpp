// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace tocsin {

/// The bytes of a file, or of anything that can be read to its end. Throws ConfigError when it
/// cannot be read, and when it has more than `longest` bytes, of which no more are read.
[[nodiscard]] std::string read_file(const std::string& path, std::size_t longest);

}  // namespace tocsin
