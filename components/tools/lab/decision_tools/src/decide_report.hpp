// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "decide.hpp"

namespace tocsin::tools {

[[nodiscard]] std::string to_text(const DecidedTrace& decided);
/// The summary and every change of state; with `rows` every row.
[[nodiscard]] nlohmann::json to_json(const DecidedTrace& decided, bool rows);
/// CSV: a row per sample; column `state` where the truth is known.
[[nodiscard]] std::string to_csv(const DecidedTrace& decided);
/// For draw(): quality with the pauses shaded, and statistic against threshold.
[[nodiscard]] nlohmann::json decide_plot(const DecidedTrace& decided);

}  // namespace tocsin::tools
