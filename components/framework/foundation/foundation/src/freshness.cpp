// SPDX-License-Identifier: Apache-2.0
#include "foundation/freshness.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tocsin {

std::string age_text(Duration age) {
  const double whole_s = std::max(0.0, std::floor(to_seconds(age)));
  if (whole_s < 100) return fmt::format("{:.0f} s", whole_s);
  const double whole_min = std::floor(whole_s / 60);
  if (whole_min < 100) return fmt::format("{:.0f} min", whole_min);
  return fmt::format("{:.0f} h", std::floor(whole_min / 60));
}

}  // namespace tocsin
