// SPDX-License-Identifier: Apache-2.0
#include "quality_trace.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "csv_tables/bag_tables.hpp"
#include "foundation/csv_table.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/numbers.hpp"
#include "foundation/printable.hpp"
#include "recorded_decisions.hpp"

namespace tocsin::tools {
namespace {

std::vector<double> numbers_or_nan(const CsvTable& table, const std::string& column) {
  return table.has(column) ? table.numbers(column) : std::vector<double>(table.rows(), nan);
}

/// The column with the time of the rows; empty when there is none.
std::string time_column(const CsvTable& table) {
  for (const char* name : {"time_s", "receive_s", "t"}) {
    if (table.has(name)) return name;
  }
  return "";
}

std::vector<double> seconds_of(const CsvTable& table, const std::string& column) {
  std::vector<double> time = table.numbers(column);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::isnan(time[i])) table.reject(i, column, "must be a time, is absent");
  }
  return time;
}

/// Seconds from the first row.
std::vector<double> from_first(const CsvTable& table, const std::string& column,
                               std::vector<double> time) {
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] >= time[i - 1]) continue;
    table.reject(i, column,
                 fmt::format("{} is {} s before the row above; rows must be in the "
                             "order of time",
                             table.texts(column)[i], fixed_text(time[i - 1] - time[i], 3)));
  }
  const double start = time.front();
  for (double& t : time) t -= start;
  return time;
}

/// When the recorded decisions were made: exact to the nanosecond, as the policy was told.
std::vector<double> decision_times(const CsvTable& table) {
  std::vector<double> time = seconds_of(table, "stamp.sec");
  const std::vector<double> fraction = seconds_of(table, "stamp.nanosec");
  const double start = time.front();
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = time[i] - start + fraction[i] * 1e-9;
  return from_first(table, "stamp.sec", std::move(time));
}

std::vector<double> times(const CsvTable& table, double period_s) {
  if (table.has("role") && table.has("stamp.sec") && table.has("stamp.nanosec")) {
    return decision_times(table);
  }
  const std::string column = time_column(table);
  if (!column.empty()) return from_first(table, column, seconds_of(table, column));
  std::vector<double> time;
  for (std::size_t i = 0; i < table.rows(); ++i) time.push_back(static_cast<double>(i) * period_s);
  return time;
}

/// Recorded network_quality: the index as the run weighed it, by default as the thesis.
std::vector<double> from_network_quality(const CsvTable& table, const decision::QniParams& params) {
  const decision::QniModel index(params);
  const auto per = table.numbers("per_percent");
  const auto signal = numbers_or_nan(table, "signal_dbm");
  const auto quality = numbers_or_nan(table, "quality_percent");
  std::vector<double> qni;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    qni.push_back(index.evaluate(decision::qni_input(per[i], signal[i], quality[i])).value);
  }
  return qni;
}

/// A lost answer counts as a lost packet, one that took more than 1 s as half of one.
double loss_percent(double delay_ms) {
  if (std::isnan(delay_ms)) return 100;
  return delay_ms > 1000 ? 50 : 0;
}

/// Measured Wi-Fi at many rows a second: a mean per whole second, which was truly bad when at least
/// half of its probes had no answer.
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
  double probes = 0;
  double lost = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (scale[i] <= 0) {
      table.reject(i, "link_quality_scale", shortest_text(scale[i]) + " must be above 0");
    }
    const double full_scale = quality[i] / scale[i] * params.quality_best;
    const double qni = model.evaluate({loss_percent(delay[i]), rssi[i], full_scale}).value;
    if (!std::isnan(qni)) sum += qni;
    count += !std::isnan(qni);
    ++probes;
    lost += std::isnan(delay[i]);
    const bool last = i + 1 == table.rows();
    if (!last && std::floor(time[i + 1]) == std::floor(time[i])) continue;
    trace.time_s.push_back(std::floor(time[i]));
    trace.qni.push_back(count > 0 ? sum / count : nan);
    trace.bad.push_back(2 * lost >= probes);
    sum = count = probes = lost = 0;
  }
}

void read_qni(const CsvTable& table, const std::string& column, double period_s,
              QualityTrace& trace) {
  trace.kind = "column " + column;
  trace.qni = table.numbers(column);
  trace.time_s = times(table, period_s);
  for (std::size_t i = 0; i < trace.qni.size(); ++i) {
    const double x = trace.qni[i];
    if ((x >= 0 && x <= 100) || std::isnan(x)) continue;
    table.reject(i, column, shortest_text(x) + " is outside [0, 100]");
  }
}

void read_network_quality(const CsvTable& table, const TraceOptions& options, QualityTrace& trace) {
  trace.kind = "network quality";
  trace.controller = controller_of_run(table.path(), options.role);
  trace.qni = from_network_quality(
      table, trace.controller ? trace.controller->quality() : decision::QniParams{});
  trace.time_s = times(table, options.period_s);
}

std::vector<bool> truth_in(const CsvTable& table) {
  const std::vector<double> states = table.numbers("state");
  std::vector<bool> bad;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != 0 && states[i] != 1) {
      table.reject(i, "state",
                   "'" + printable(table.texts("state")[i]) + "' is not 0 (good) or 1 (bad)");
    }
    bad.push_back(states[i] == 1);
  }
  return bad;
}

[[noreturn]] void reject(const CsvTable& table) {
  throw ConfigError(table.path() +
                    ": has no column qni, per_percent or rssi_dbm (--column names another), has: " +
                    printable(joined(table.columns())));
}

/// Of a CSV file, or of a topic of a bag or of the bags of a recorder's folder. Throws ConfigError.
CsvTable read_table(const std::string& path, const std::string& topic) {
  const auto bags = is_bag(path) ? std::vector{path} : recorded_bags(path);
  if (bags.empty()) return CsvTable::load(path);
  const BagTables bag(bags, [&topic](const std::string& one) { return one == topic; });
  if (bag.of(topic).empty()) {
    throw ConfigError(path + ": has no message of topic " + printable(topic) +
                      " of a type that is known here (--topic names another)");
  }
  return CsvTable::parse(bag.of(topic), path);
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
  CsvTable table = read_table(path, options.topic);
  QualityTrace trace;
  trace.path = path;
  trace.role = keep_one_role(table, options.role);
  drop_repeated_decisions(table);
  if (!options.column.empty()) {
    read_qni(table, options.column, options.period_s, trace);
  } else if (table.has("qni")) {
    read_qni(table, "qni", options.period_s, trace);
  } else if (table.has("per_percent")) {
    read_network_quality(table, options, trace);
  } else if (table.has("rssi_dbm")) {
    trace.kind = "measured Wi-Fi";
    from_wifi(table, trace);
  } else {
    reject(table);
  }
  if (trace.role) {
    trace.controller = controller_of_run(path, trace.role);
    if (options.column.empty()) read_decisions(table, trace);
  }
  if (options.role && !trace.role && !trace.controller) {
    throw ConfigError(path + ": --host " + to_string(*options.role) +
                      ": the file has no column role and no deployment.yaml beside it");
  }
  if (trace.bad.empty() && table.has("state") && trace.qni.size() == table.rows()) {
    trace.bad = truth_in(table);
  }
  return trace;
}

}  // namespace tocsin::tools
