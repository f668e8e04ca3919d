// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tocsin {

/// The number that a cell holds; NaN when it is empty or not one.
[[nodiscard]] double csv_number(const std::string& cell);

struct CsvRow {
  std::size_t line = 1;  ///< at which it begins
  std::vector<std::string> cells;
};

/// Takes rows off a CSV text (RFC 4180, lines ended by LF or CR LF). The text must outlive it.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {}
  /// The next row, an empty line included as one empty cell; nothing at the end.
  [[nodiscard]] std::optional<CsvRow> next();

 private:
  bool took(char wanted);
  [[nodiscard]] std::string cell();
  [[nodiscard]] std::string quoted();
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// A CSV text whose first row names the columns. Empty lines do not count.
class CsvTable {
 public:
  /// Of a recording that may have been cut off anywhere: rows with another number of cells than
  /// the first one are left out and counted.
  explicit CsvTable(std::string_view text);
  /// The same of a file; empty when there is none.
  [[nodiscard]] static CsvTable read(const std::string& path);
  /// Of a file that a person gives. Throws ConfigError when it cannot be read, is empty, has a row
  /// of another length, or no row besides the names.
  [[nodiscard]] static CsvTable load(const std::string& path);
  /// The same of a text that was made of the file `path`.
  [[nodiscard]] static CsvTable parse(std::string_view text, const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] std::size_t bad_rows() const { return bad_rows_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] bool has(const std::string& column) const { return find(column).has_value(); }
  /// The cell's text; empty when there is no such column.
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const;
  /// The cell's number; NaN when it is not one.
  [[nodiscard]] double number(std::size_t row, const std::string& column) const;
  /// The numbers of a column; NaN for empty cells and the words nan and NaN. Throws ConfigError
  /// naming file, line, column and text for anything else, and when there is no such column.
  [[nodiscard]] std::vector<double> numbers(const std::string& column) const;
  /// The texts of a column without spaces around them. Throws ConfigError when there is none.
  [[nodiscard]] std::vector<std::string> texts(const std::string& column) const;
  /// Keeps the rows for which `wanted`, one per row, is true.
  void keep(const std::vector<bool>& wanted);
  /// Throws ConfigError "file:line: column: what".
  [[noreturn]] void reject(std::size_t row, const std::string& column,
                           const std::string& what) const;

 private:
  CsvTable() = default;
  [[nodiscard]] std::optional<std::size_t> find(const std::string& column) const;

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<CsvRow> rows_;
  std::size_t bad_rows_ = 0;
};

}  // namespace tocsin
