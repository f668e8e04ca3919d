// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "decision/design/fit.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

/// The fits of one recording, best first.
struct FitReport {
  QualityTrace trace;
  std::size_t missing;  ///< rows without a measurement
  decision::FitData data;
  std::vector<decision::Fit> fits;
  decision::Density chosen;
};

/// Fits all families and chooses the first of the ranking, or `family` when it is not empty.
/// Throws ConfigError when the data cannot be fitted or there is no such family.
[[nodiscard]] FitReport fit_trace(const QualityTrace& trace, const std::string& family);

/// "name(a=1, b=2)".
[[nodiscard]] std::string describe(const decision::Density& law);
[[nodiscard]] std::string to_text(const FitReport& report);
[[nodiscard]] nlohmann::json to_json(const FitReport& report);

/// For draw(): histograms of both recordings against their chosen densities, as figures 27
/// and 28 of the thesis.
[[nodiscard]] nlohmann::json fit_plot(const FitReport& good, const FitReport& bad);

}  // namespace tocsin::tools
