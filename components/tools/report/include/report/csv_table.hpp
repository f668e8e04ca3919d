// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tocsin::report {

/// The number that a cell holds; NaN when it is empty or not one.
[[nodiscard]] double number_of(const std::string& cell);

/// A CSV text (RFC 4180) whose first row names the columns.
///
/// A recording may have been cut off anywhere: rows with another number of cells than the first
/// one are left out and counted.
class CsvTable {
 public:
  explicit CsvTable(std::string_view text);
  /// The table of a file; empty when there is none.
  [[nodiscard]] static CsvTable read(const std::string& path);

  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  [[nodiscard]] std::size_t bad_rows() const { return bad_rows_; }
  [[nodiscard]] bool has(const std::string& column) const;
  /// The cell's text; empty when there is no such column.
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const;
  /// The cell's number; NaN when it is not one.
  [[nodiscard]] double number(std::size_t row, const std::string& column) const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t bad_rows_ = 0;
};

}  // namespace tocsin::report
