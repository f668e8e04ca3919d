// SPDX-License-Identifier: Apache-2.0
#include "command_line/said_time.hpp"

#include <charconv>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin {

std::int64_t time_of(const std::string& name, const std::string& text, std::int64_t clock_ns) {
  constexpr double latest_s = 9e9;
  double s = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), s);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (!is_number || !std::isfinite(s) || std::fabs(s) > latest_s) {
    throw ConfigError(name + ": '" + printable(text) +
                      "' is no time: seconds since 1970, or 0 and below before now");
  }
  const auto ns = static_cast<std::int64_t>(s * 1e9);
  return s > 0 ? ns : clock_ns + ns;
}

}  // namespace tocsin
