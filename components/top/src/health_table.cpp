// SPDX-License-Identifier: Apache-2.0
#include "health_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>

namespace tocsin::top {
namespace {

using diagnostic_msgs::msg::DiagnosticStatus;

constexpr Duration stale_after = std::chrono::seconds(3);
constexpr Duration gone_after = std::chrono::seconds(30);
constexpr std::uint8_t stale = diagnostic_msgs::msg::DiagnosticStatus_Constants::STALE;

const char* level_text(std::uint8_t level) {
  constexpr std::array names{"OK", "WARN", "ERROR", "STALE"};
  return names[std::min<std::size_t>(level, names.size() - 1)];
}

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string value_of(const DiagnosticStatus& status, const std::string& key) {
  for (const auto& pair : status.values()) {
    if (pair.key() == key) return pair.value();
  }
  return "-";
}

/// What the inputs of a status sum up to.
struct Inputs {
  bool any = false;
  bool never = false;
  double oldest_s = 0;
  unsigned long depth = 0;
  unsigned long dropped = 0;
};

Inputs inputs_of(const DiagnosticStatus& status) {
  Inputs sums;
  for (const auto& pair : status.values()) {
    const char* const text = pair.value().c_str();
    if (ends_with(pair.key(), ".dropped")) sums.dropped += std::strtoul(text, nullptr, 10);
    if (ends_with(pair.key(), ".depth")) {
      sums.depth = std::max(sums.depth, std::strtoul(text, nullptr, 10));
    }
    if (!ends_with(pair.key(), ".age_s")) continue;
    sums.any = true;
    sums.never = sums.never || pair.value() == "never";
    sums.oldest_s = std::max(sums.oldest_s, std::strtod(text, nullptr));
  }
  return sums;
}

Row row_of(const DiagnosticStatus& status, std::uint8_t level) {
  const Inputs inputs = inputs_of(status);
  Row row;
  row.name = status.name();
  row.host = status.hardware_id();
  row.level = level_text(level);
  row.message = status.message();
  row.rate_hz = value_of(status, "rate_hz");
  row.tick_p99_s = value_of(status, "tick_p99_s");
  row.tick_max_s = value_of(status, "tick_max_s");
  row.overruns = value_of(status, "overruns");
  row.resident_mib = value_of(status, "resident_mib");
  row.depth = inputs.any ? std::to_string(inputs.depth) : "-";
  row.dropped = inputs.any ? std::to_string(inputs.dropped) : "-";
  row.oldest_age = !inputs.any    ? "-"
                   : inputs.never ? "never"
                                  : fmt::format("{:.1f}", inputs.oldest_s);
  return row;
}

}  // namespace

void HealthTable::add(const diagnostic_msgs::msg::DiagnosticArray& array, Time now) {
  for (const DiagnosticStatus& status : array.status()) {
    entries_[status.hardware_id() + "/" + status.name()] = {status, now};
  }
}

std::vector<Row> HealthTable::rows(Time now) const {
  std::vector<std::tuple<int, std::string, Row>> graded;
  for (const auto& [key, entry] : entries_) {
    if (now - entry.at > gone_after) continue;
    const std::uint8_t level = now - entry.at > stale_after ? stale : entry.status.level();
    graded.emplace_back(-int{level}, key, row_of(entry.status, level));
  }
  std::sort(graded.begin(), graded.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  std::vector<Row> rows;
  for (auto& one : graded) rows.push_back(std::move(std::get<2>(one)));
  return rows;
}

std::string to_text(const std::vector<Row>& rows, std::size_t width) {
  constexpr auto* format = "{:5} {:32} {:>8} {:>10} {:>10} {:>8} {:>5} {:>7} {:>7} {:>7}  {}";
  const auto cut = [width](const std::string& line) { return line.substr(0, width) + "\n"; };
  std::string text = cut(fmt::format(format, "LEVEL", "NAME", "RATE/Hz", "P99/s", "MAX/s",
                                     "OVERRUNS", "DEPTH", "DROPPED", "AGE/s", "MEM/MiB", "STATE"));
  for (const Row& row : rows) {
    const std::string line = fmt::format(format, row.level, row.name, row.rate_hz, row.tick_p99_s,
                                         row.tick_max_s, row.overruns, row.depth, row.dropped,
                                         row.oldest_age, row.resident_mib, row.message);
    text += cut(line);
    if (row.level != level_text(0) && line.size() > width) text += cut("      " + row.message);
  }
  return text;
}

std::string to_json(const std::vector<Row>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const Row& row : rows) {
    list.push_back({{"name", row.name},
                    {"host", row.host},
                    {"level", row.level},
                    {"message", row.message},
                    {"rate_hz", row.rate_hz},
                    {"tick_p99_s", row.tick_p99_s},
                    {"tick_max_s", row.tick_max_s},
                    {"overruns", row.overruns},
                    {"resident_mib", row.resident_mib},
                    {"depth", row.depth},
                    {"dropped", row.dropped},
                    {"oldest_age_s", row.oldest_age}});
  }
  return list.dump() + "\n";
}

}  // namespace tocsin::top
