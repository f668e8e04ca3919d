// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "foundation/csv_table.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {
namespace {

constexpr const char* series_head =
    "time_s,qni,probe_per,snr_db,active,poor,sent,lost,latency_ms,stalled";

/// Empty for NaN.
std::string number(double value) {
  if (std::isnan(value)) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
  return text;
}

std::vector<double> numbers(const std::string& line) {
  std::vector<double> values;
  const auto row = CsvReader(line).next();
  if (!row) return values;
  for (const std::string& cell : row->cells) values.push_back(csv_number(cell));
  return values;
}

std::string joined(const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? "," : "") + number(values[i]);
  return text;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::optional<Observation> parse_observation(const std::string& line) {
  const std::vector<double> v = numbers(line);
  if (v.size() != 10) return std::nullopt;
  return Observation{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9] == 1};
}

bool take(std::istringstream& lines, const std::string& prefix, std::string& rest) {
  std::string line;
  if (!std::getline(lines, line) || line.rfind(prefix, 0) != 0) return false;
  rest = line.substr(prefix.size());
  return true;
}

}  // namespace

std::string to_text(const RunResult& result) {
  std::string text = "failure " + one_line(result.failure) + "\nseconds " +
                     number(result.simulated_s) + "\nvalues " + joined(result.measures.values) +
                     "\n" + series_head + "\n";
  for (const Observation& one : result.measures.series) {
    text += joined({one.time_s, one.qni, one.probe_per, one.snr_db, one.active, one.poor, one.sent,
                    one.lost, one.latency_ms, one.stalled ? 1.0 : 0.0}) +
            "\n";
  }
  return text + "end\n";
}

std::optional<RunResult> parse_result(const std::string& text) {
  std::istringstream lines(text);
  RunResult result;
  std::string rest;
  if (!take(lines, "failure ", result.failure) || !take(lines, "seconds ", rest)) {
    return std::nullopt;
  }
  result.simulated_s = std::strtod(rest.c_str(), nullptr);
  if (!take(lines, "values ", rest)) return std::nullopt;
  result.measures.values = numbers(rest);
  result.measures.values.resize(metric_count, std::nan(""));
  if (!take(lines, series_head, rest)) return std::nullopt;
  for (std::string line; std::getline(lines, line);) {
    if (line == "end") return result;
    const auto observation = parse_observation(line);
    if (!observation) return std::nullopt;
    result.measures.series.push_back(*observation);
  }
  return std::nullopt;
}

}  // namespace tocsin::experiment
