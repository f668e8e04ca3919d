// SPDX-License-Identifier: Apache-2.0
#include "trace_options.hpp"

#include <charconv>
#include <cmath>
#include <map>

#include "command_line/host_option.hpp"
#include "command_line/option_checks.hpp"
#include "foundation/error.hpp"

namespace tocsin::tools {

void declare_trace_options(CLI::App& app, TraceOptions& options) {
  app.add_option("--column", options.column, "column with the quality [qni or what it rests on]");
  app.add_option("--topic", options.topic, "of a bag [" + options.topic + "]");
  add_role_option(app, options.role,
                  "whose recorded decisions: uxv or gcs; needed when there are both");
  app.add_option("--period", options.period_s, "seconds between rows of a file without time [1]")
      ->check(above_zero());
}

double parse_duration_s(const std::string& name, const std::string& text) {
  static const std::map<std::string, double> units{{"", 1},     {"s", 1},     {"min", 60},
                                                   {"h", 3600}, {"d", 86400}, {"w", 604800}};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const auto unit = units.find(std::string(end, text.data() + text.size()));
  const bool read = error == std::errc{} && unit != units.end();
  const double seconds = read ? value * unit->second : 0;
  if (!std::isfinite(seconds) || seconds <= 0) {
    throw ConfigError(name + ": '" + text + "' is not a duration such as 90s, 5min, 1h, 2d");
  }
  return seconds;
}

}  // namespace tocsin::tools
