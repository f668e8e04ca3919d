// SPDX-License-Identifier: Apache-2.0
#include "foundation/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest = std::size_t{1} << 30;  // [byte] of a file that is read whole

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool is_empty(const CsvRow& row) { return row.cells.size() == 1 && trimmed(row.cells[0]).empty(); }

std::string place(const std::string& path, std::size_t line) {
  return fmt::format("{}:{}: ", path, line);
}

}  // namespace

double csv_number(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  return cell.empty() || *end != '\0' ? std::nan("") : value;
}

std::optional<CsvRow> CsvReader::next() {
  if (at_ >= text_.size()) return std::nullopt;
  CsvRow row{line_, {}};
  do {
    row.cells.push_back(cell());
  } while (took(','));
  (void)took('\r');
  (void)took('\n');
  return row;
}

bool CsvReader::took(char wanted) {
  const bool is_there = at_ < text_.size() && text_[at_] == wanted;
  if (!is_there) return false;
  ++at_;
  if (wanted == '\n') ++line_;
  return true;
}

std::string CsvReader::cell() {
  if (took('"')) return quoted();
  const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
  const std::size_t begin = std::exchange(at_, end);
  return std::string(text_.substr(begin, end - begin));
}

std::string CsvReader::quoted() {
  std::string cell;
  while (at_ < text_.size()) {
    const char next = text_[at_++];
    if (next == '"' && !took('"')) break;
    if (next == '\n') ++line_;
    cell += next;
  }
  return cell;
}

CsvTable::CsvTable(std::string_view text) {
  CsvReader reader(text);
  if (const auto head = reader.next()) {
    for (const std::string& name : head->cells) columns_.push_back(trimmed(name));
  }
  while (auto row = reader.next()) {
    if (row->cells.size() == columns_.size() && !is_empty(*row)) {
      rows_.push_back(std::move(*row));
    } else if (!is_empty(*row)) {
      ++bad_rows_;
    }
  }
}

CsvTable CsvTable::read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  CsvTable table(text.str());
  table.path_ = path;
  return table;
}

CsvTable CsvTable::load(const std::string& path) { return parse(read_file(path, longest), path); }

CsvTable CsvTable::parse(std::string_view text, const std::string& path) {
  if (text.empty()) throw ConfigError(path + ": is empty, must be CSV");
  CsvReader reader(text);
  CsvTable table;
  table.path_ = path;
  if (const auto head = reader.next()) {
    for (const std::string& name : head->cells) table.columns_.push_back(trimmed(name));
  }
  while (auto row = reader.next()) {
    if (is_empty(*row)) continue;
    if (row->cells.size() != table.columns_.size()) {
      throw ConfigError(fmt::format("{}{} cells, must be {} as in the first row",
                                    place(path, row->line), row->cells.size(),
                                    table.columns_.size()));
    }
    table.rows_.push_back(std::move(*row));
  }
  if (table.rows_.empty()) throw ConfigError(path + ": has no row besides the first");
  return table;
}

std::optional<std::size_t> CsvTable::find(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  static const std::string none;
  const auto at = find(column);
  return at ? rows_[row].cells[*at] : none;
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  return csv_number(text(row, column));
}

std::vector<std::string> CsvTable::texts(const std::string& column) const {
  const auto at = find(column);
  if (!at) {
    throw ConfigError(
        fmt::format("{}: has no column '{}', has: {}", path_, column, printable(joined(columns_))));
  }
  std::vector<std::string> all;
  all.reserve(rows_.size());
  for (const CsvRow& row : rows_) all.push_back(trimmed(row.cells[*at]));
  return all;
}

std::vector<double> CsvTable::numbers(const std::string& column) const {
  std::vector<double> values;
  for (const std::string& text : texts(column)) {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!text.empty() && text != "nan" && text != "NaN") {
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        reject(values.size(), column, "'" + printable(text) + "' is not a number");
      }
    }
    values.push_back(value);
  }
  return values;
}

void CsvTable::keep(const std::vector<bool>& wanted) {
  std::vector<CsvRow> kept;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (wanted[i]) kept.push_back(std::move(rows_[i]));
  }
  rows_ = std::move(kept);
}

void CsvTable::reject(std::size_t row, const std::string& column, const std::string& what) const {
  throw ConfigError(place(path_, rows_[row].line) + column + ": " + what);
}

}  // namespace tocsin
