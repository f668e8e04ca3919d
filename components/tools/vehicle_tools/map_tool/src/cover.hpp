// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "coverage/coverage_plan.hpp"

namespace tocsin::map_tool {

/// What `tocsin map cover` is asked for.
struct CoverOptions {
  std::string map;
  std::string mission;
  std::string picture;
  std::string start = "0,0";
  std::vector<std::string> polygon;
  coverage::CoverageParams params;
};

/// "x,y" [m]. Throws ConfigError naming `option` and the text.
[[nodiscard]] geometry::Point point_in(const std::string& text, const char* option);

/// The map in grey with what is left out (160) and the drive (80), as a PGM image.
[[nodiscard]] std::string picture_of(const navigation::OccupancyMap& map,
                                     const coverage::CoveragePlan& plan);

/// Writes the mission and the picture; the measures as a line. Throws ConfigError.
[[nodiscard]] std::string cover(const CoverOptions& options);

}  // namespace tocsin::map_tool
