// SPDX-License-Identifier: Apache-2.0
#include "quality_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csv_table.hpp"
#include "decision/qni.hpp"
#include "foundation/error.hpp"

namespace tocsin::tools {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> numbers_or_nan(const CsvTable& table, const std::string& column) {
  return table.has(column) ? table.numbers(column) : std::vector<double>(table.rows(), nan);
}

/// Seconds from the first row. A clock that was set back is not an error: policies must bear it.
std::vector<double> times(const CsvTable& table, double period_s) {
  for (const char* name : {"time_s", "receive_s", "t"}) {
    if (!table.has(name)) continue;
    std::vector<double> time = table.numbers(name);
    for (double& t : time) {
      if (std::isnan(t)) throw ConfigError(table.path() + ": a row has no " + name);
    }
    const double start = time.front();
    for (double& t : time) t -= start;
    return time;
  }
  std::vector<double> time;
  for (std::size_t i = 0; i < table.rows(); ++i) time.push_back(static_cast<double>(i) * period_s);
  return time;
}

/// Recorded by network_quality: the thesis's index with its default weights.
std::vector<double> from_network_quality(const CsvTable& table) {
  const decision::QniParams params;
  const decision::QniModel model(params);
  const auto per = table.numbers("per_percent");
  const auto signal = numbers_or_nan(table, "signal_dbm");
  const auto quality = numbers_or_nan(table, "quality_percent");
  std::vector<double> qni;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double full_scale = quality[i] / 100 * params.quality_best;
    qni.push_back(model.evaluate({per[i], signal[i], full_scale}).value);
  }
  return qni;
}

/// A lost answer counts as a lost packet, one that took more than 1 s as half of one.
double loss_percent(double delay_ms) {
  if (std::isnan(delay_ms)) return 100;
  return delay_ms > 1000 ? 50 : 0;
}

/// Measured Wi-Fi at many rows a second: a mean per whole second.
void from_wifi(const CsvTable& table, QualityTrace& trace) {
  const decision::QniParams params;
  const decision::QniModel model(params);
  const auto rssi = table.numbers("rssi_dbm");
  const auto quality = table.numbers("link_quality");
  const auto scale = table.numbers("link_quality_scale");
  const auto delay = table.numbers("ping_delay_ms");
  const auto time = times(table, 1);
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double full_scale = quality[i] / scale[i] * params.quality_best;
    const double qni = model.evaluate({loss_percent(delay[i]), rssi[i], full_scale}).value;
    if (!std::isnan(qni)) sum += qni;
    count += !std::isnan(qni);
    const bool last = i + 1 == table.rows();
    if (!last && std::floor(time[i + 1]) == std::floor(time[i])) continue;
    trace.time_s.push_back(std::floor(time[i]));
    trace.qni.push_back(count > 0 ? sum / count : nan);
    sum = count = 0;
  }
}

void read_qni(const CsvTable& table, const std::string& column, double period_s,
              QualityTrace& trace) {
  trace.kind = "column " + column;
  trace.qni = table.numbers(column);
  trace.time_s = times(table, period_s);
  for (const double x : trace.qni) {
    if (x >= 0 && x <= 100) continue;
    if (std::isnan(x)) continue;
    throw ConfigError(table.path() + ": " + column + ": " + std::to_string(x) +
                      " is outside [0, 100]");
  }
}

[[noreturn]] void reject(const CsvTable& table) {
  std::string known;
  for (const std::string& name : table.columns()) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError(
      table.path() +
      ": has no column qni, per_percent or rssi_dbm (--column names another), has: " + known);
}

}  // namespace

std::vector<double> QualityTrace::measured() const {
  std::vector<double> values;
  for (const double x : qni) {
    if (!std::isnan(x)) values.push_back(x);
  }
  return values;
}

QualityTrace read_quality_trace(const std::string& path, const TraceOptions& options) {
  CsvTable table(path);
  if (!options.role.empty()) table.keep("role", options.role);
  QualityTrace trace;
  trace.path = path;
  if (!options.column.empty()) {
    read_qni(table, options.column, options.period_s, trace);
  } else if (table.has("qni")) {
    read_qni(table, "qni", options.period_s, trace);
  } else if (table.has("per_percent")) {
    trace.kind = "network quality";
    trace.qni = from_network_quality(table);
    trace.time_s = times(table, options.period_s);
  } else if (table.has("rssi_dbm")) {
    trace.kind = "measured Wi-Fi";
    from_wifi(table, trace);
  } else {
    reject(table);
  }
  if (table.has("state") && trace.qni.size() == table.rows()) {
    for (const double state : table.numbers("state")) trace.bad.push_back(state > 0.5);
  }
  return trace;
}

}  // namespace tocsin::tools
