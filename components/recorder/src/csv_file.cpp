// SPDX-License-Identifier: Apache-2.0
#include "recorder/csv_file.hpp"

#include <cstring>
#include <filesystem>

#include "foundation/error.hpp"
#include "recorder/flat_message.hpp"

namespace tocsin {
namespace {

std::string row_of(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) row += ',';
    row += csv_cell(cell);
  }
  return row + '\n';
}

/// A process that was killed may have left half a row behind.
bool ends_with_newline(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || file.tellg() == 0) return true;
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

}  // namespace

CsvFile::CsvFile(const std::string& path, const std::vector<std::string>& columns) : path_(path) {
  std::error_code none;
  const bool empty =
      !std::filesystem::exists(path, none) || std::filesystem::file_size(path, none) == 0;
  const bool whole = ends_with_newline(path);
  file_.open(path, std::ios::app);
  if (!file_) throw ConfigError(path + ": cannot be written: " + std::strerror(errno));
  if (!whole) file_ << '\n';
  if (empty) file_ << row_of(columns);
}

bool CsvFile::write(const std::vector<std::string>& cells) {
  file_ << row_of(cells);
  return file_.good();
}

bool CsvFile::flush() {
  file_.flush();
  if (file_.good()) return true;
  file_.clear();
  file_ << '\n';
  return false;
}

}  // namespace tocsin
