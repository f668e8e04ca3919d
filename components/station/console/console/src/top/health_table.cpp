// SPDX-License-Identifier: Apache-2.0
#include "health_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>

#include "foundation/ends_with.hpp"
#include "foundation/printable.hpp"

namespace tocsin::top {
namespace {

using diagnostic_msgs::msg::DiagnosticStatus;
namespace DiagnosticStatus_Constants = diagnostic_msgs::msg::DiagnosticStatus_Constants;

constexpr Duration forgotten_after = std::chrono::minutes(10);
constexpr std::uint8_t stale = DiagnosticStatus_Constants::STALE;

const char* level_text(std::uint8_t level) {
  constexpr std::array names{"OK", "WARN", "ERROR", "STALE"};
  return names[std::min<std::size_t>(level, names.size() - 1)];
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

bool is_process(const DiagnosticStatus& status) {
  return status.name().find('/') == std::string::npos;
}

terminal::Style style_of(const Row& row) {
  if (row.level == "ERROR") return terminal::Style::bad;
  if (row.level == "WARN") return terminal::Style::warning;
  return row.level == "STALE" ? terminal::Style::old : terminal::Style::plain;
}

terminal::Table table_of(const std::vector<Row>& rows) {
  using terminal::Align;
  constexpr std::size_t name_column = 1;
  terminal::Table table({{"LEVEL", Align::left, 0, 5},
                         {"NAME"},
                         {"RATE/Hz", Align::right, 3},
                         {"P99/s", Align::right, 2, 8},
                         {"MAX/s", Align::right, 7, 8},
                         {"OVERRUNS", Align::right, 5},
                         {"DEPTH", Align::right, 8},
                         {"DROPPED", Align::right, 1},
                         {"AGE/s", Align::right, 4},
                         {"MEM/MiB", Align::right, 6}},
                        name_column);
  for (const Row& row : rows) {
    std::vector<terminal::Cell> cells;
    for (const std::string* text :
         {&row.level, &row.name, &row.rate_hz, &row.tick_p99_s, &row.tick_max_s, &row.overruns,
          &row.depth, &row.dropped, &row.oldest_age, &row.resident_mib}) {
      cells.push_back({*text, style_of(row)});
    }
    table.add(std::move(cells));
  }
  return table;
}

std::size_t width_of(const terminal::Line& line) {
  std::size_t width = 0;
  for (const terminal::Span& span : line) width += terminal::width_of(span.text);
  return width;
}

std::string gone_text(const std::vector<Gone>& gone) {
  std::string text;
  for (const Gone& one : gone) {
    text += (text.empty() ? "gone: " : ", ") + one.name + " for " + age_text(one.age);
  }
  return text;
}

/// Puts a row's message beside its figures, or below them when it does not fit there and matters.
void add_row(const Row& row, terminal::Line figures, std::size_t width,
             std::vector<terminal::Line>& lines) {
  const std::string message = printable(row.message);
  const bool beside = width_of(figures) + 2 + terminal::width_of(message) <= width;
  if (beside) figures.push_back({"  " + message, style_of(row)});
  lines.push_back(std::move(figures));
  if (!beside && row.level != level_text(DiagnosticStatus_Constants::OK)) {
    lines.push_back({{"      " + message, style_of(row)}});
  }
}

}  // namespace

void HealthTable::add(const diagnostic_msgs::msg::DiagnosticArray& array, std::uint64_t source,
                      Time now) {
  for (const DiagnosticStatus& status : array.status()) {
    entries_[status.hardware_id() + "/" + status.name()] = {status, source, now};
  }
  for (auto it = entries_.begin(); it != entries_.end();) {
    const Duration age = now - it->second.at;
    const bool ended = it->second.source == source && freshness(age) != Freshness::fresh;
    it = ended || age > forgotten_after ? entries_.erase(it) : std::next(it);
  }
}

std::vector<Row> HealthTable::rows(Time now) const {
  std::vector<std::tuple<int, std::string, Row>> graded;
  for (const auto& [key, entry] : entries_) {
    const Duration age = now - entry.at;
    const Freshness state = freshness(age);
    if (state == Freshness::unknown) continue;
    const bool silent = state == Freshness::stale;
    const std::uint8_t level = silent ? stale : entry.status.level();
    Row row = row_of(entry.status, level);
    row.age = age;
    if (silent) row.message = "silent for " + age_text(age);
    graded.emplace_back(-int{level}, entry.status.name(), std::move(row));
  }
  std::sort(graded.begin(), graded.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  std::vector<Row> rows;
  for (auto& one : graded) rows.push_back(std::move(std::get<2>(one)));
  return rows;
}

std::vector<Gone> HealthTable::gone(Time now) const {
  std::vector<Gone> all;
  for (const auto& [key, entry] : entries_) {
    const Duration age = now - entry.at;
    if (freshness(age) != Freshness::unknown || age > forgotten_after) continue;
    if (is_process(entry.status)) all.push_back({entry.status.name(), age});
  }
  return all;
}

std::vector<terminal::Line> page(const std::vector<Row>& rows, const std::vector<Gone>& gone,
                                 std::size_t width) {
  constexpr std::size_t shortest_message = 16;  // with two blanks before it
  const std::size_t left = std::max(width, 2 * shortest_message) - shortest_message;
  std::vector<terminal::Line> figures = table_of(rows).lines(left);
  std::vector<terminal::Line> lines;
  figures.front().push_back({"  STATE", terminal::Style::bold});
  lines.push_back(std::move(figures.front()));
  if (!gone.empty()) lines.push_back({{gone_text(gone), terminal::Style::warning}});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    add_row(rows[i], std::move(figures[i + 1]), width, lines);
  }
  return lines;
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
                    {"oldest_age_s", row.oldest_age},
                    {"report_age_s", to_seconds(row.age)}});
  }
  // Text of other programs may not be UTF-8; JSON must be.
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tocsin::top
