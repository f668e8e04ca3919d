// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "quality_trace.hpp"

namespace tocsin::tools {

/// The options of every program that reads traces.
void declare_trace_options(CLI::App& app, TraceOptions& options);

/// "90", "90s", "5min", "1h", "2d" in seconds. Throws ConfigError naming `name` for anything else.
[[nodiscard]] double parse_duration_s(const std::string& name, const std::string& text);

}  // namespace tocsin::tools
