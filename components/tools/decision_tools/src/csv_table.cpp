// SPDX-License-Identifier: Apache-2.0
#include "csv_table.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::tools {
namespace {

/// The cells of one line; a quoted cell may hold commas and doubled quotes.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string place(const std::string& path, std::size_t line) {
  return path + ":" + std::to_string(line) + ": ";
}

}  // namespace

CsvTable::CsvTable(const std::string& path) : path_(path) {
  if (std::filesystem::is_directory(path)) throw ConfigError(path + ": is a folder, not a file");
  std::ifstream file(path);
  if (!file) throw ConfigError(path + ": cannot be read: " + std::strerror(errno));
  std::string line;
  if (!std::getline(file, line)) throw ConfigError(path + ": is empty, must be CSV");
  for (const std::string& name : split(line)) columns_.push_back(trimmed(name));
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    if (trimmed(line).empty() || line == "\r") continue;
    Row row{number, split(line)};
    if (row.cells.size() != columns_.size()) {
      throw ConfigError(place(path, number) + std::to_string(row.cells.size()) +
                        " cells, must be " + std::to_string(columns_.size()) +
                        " as in the first row");
    }
    rows_.push_back(std::move(row));
  }
  if (rows_.empty()) throw ConfigError(path + ": has no row besides the first");
}

bool CsvTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t CsvTable::index(const std::string& column) const {
  const auto it = std::find(columns_.begin(), columns_.end(), column);
  if (it != columns_.end()) return static_cast<std::size_t>(it - columns_.begin());
  std::string known;
  for (const std::string& name : columns_) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError(path_ + ": has no column '" + column + "', has: " + printable(known));
}

std::vector<std::string> CsvTable::texts(const std::string& column) const {
  const std::size_t at = index(column);
  std::vector<std::string> all;
  all.reserve(rows_.size());
  for (const Row& row : rows_) all.push_back(trimmed(row.cells[at]));
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
  std::vector<Row> kept;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (wanted[i]) kept.push_back(std::move(rows_[i]));
  }
  rows_ = std::move(kept);
}

void CsvTable::reject(std::size_t row, const std::string& column, const std::string& what) const {
  throw ConfigError(place(path_, rows_[row].line) + column + ": " + what);
}

}  // namespace tocsin::tools
