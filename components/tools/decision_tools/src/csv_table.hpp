// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::tools {

/// A CSV file (RFC 4180) as texts. The first row names the columns.
class CsvTable {
 public:
  /// Throws ConfigError when the file cannot be read, is empty, has a row of another length, or has
  /// no row besides the names.
  explicit CsvTable(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] bool has(const std::string& column) const;
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// The numbers of a column; NaN for empty cells and the words nan and NaN.
  /// Throws ConfigError naming file, line, column and text for anything else.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
  /// The texts of a column without spaces around them.
  [[nodiscard]] std::vector<std::string> texts(const std::string& column) const;
  /// Keeps the rows for which `wanted`, one per row, is true.
  void keep(const std::vector<bool>& wanted);
  /// Throws ConfigError "file:line: column: what".
  [[noreturn]] void reject(std::size_t row, const std::string& column,
                           const std::string& what) const;

 private:
  [[nodiscard]] std::size_t index(const std::string& column) const;

  std::string path_;
  std::vector<std::string> columns_;
  struct Row {
    std::size_t line;
    std::vector<std::string> cells;
  };
  std::vector<Row> rows_;
};

}  // namespace tocsin::tools
