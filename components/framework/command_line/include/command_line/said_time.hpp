// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tocsin {

/// A time that a person said: above 0 in seconds since the Unix epoch, else in seconds before the
/// `clock_ns`. `name` stands in front of the error. Throws ConfigError for what is neither.
[[nodiscard]] std::int64_t time_of(const std::string& name, const std::string& text,
                                   std::int64_t clock_ns);

}  // namespace tocsin
