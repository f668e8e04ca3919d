// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mapping/global_mapper.hpp"

namespace tocsin::mapping {

/// A session as the bytes of a file: version, content, check sum. Of the same machine's byte order.
[[nodiscard]] std::string bytes_of(const MapSession& session);

/// Reads what `bytes_of` has made. Throws ConfigError beginning with `name` when it is of another
/// kind or version, cut, damaged, or contradicts itself.
[[nodiscard]] MapSession session_in(const std::string& bytes, const std::string& name);

}  // namespace tocsin::mapping
