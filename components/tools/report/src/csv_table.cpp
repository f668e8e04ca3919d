// SPDX-License-Identifier: Apache-2.0
#include "report/csv_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace tocsin::report {
namespace {

/// Takes rows off a text.
class RowReader {
 public:
  explicit RowReader(std::string_view text) : text_(text) {}

  /// The next row; nothing at the end.
  std::optional<std::vector<std::string>> next() {
    if (at_ >= text_.size()) return std::nullopt;
    std::vector<std::string> cells;
    do {
      cells.push_back(cell());
    } while (took(','));
    (void)took('\r');
    (void)took('\n');
    return cells;
  }

 private:
  bool took(char wanted) {
    const bool is_there = at_ < text_.size() && text_[at_] == wanted;
    if (is_there) ++at_;
    return is_there;
  }

  std::string cell() {
    if (took('"')) return quoted();
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    return std::string(text_.substr(std::exchange(at_, end), end - at_));
  }

  std::string quoted() {
    std::string cell;
    while (at_ < text_.size()) {
      const char next = text_[at_++];
      if (next == '"' && !took('"')) break;
      cell += next;
    }
    return cell;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

double number_of(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  return cell.empty() || *end != '\0' ? std::nan("") : value;
}

CsvTable::CsvTable(std::string_view text) {
  RowReader reader(text);
  if (auto head = reader.next()) columns_ = std::move(*head);
  while (auto row = reader.next()) {
    if (row->size() == columns_.size()) {
      rows_.push_back(std::move(*row));
    } else if (row->size() > 1 || !row->front().empty()) {
      ++bad_rows_;
    }
  }
}

CsvTable CsvTable::read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return CsvTable(text.str());
}

bool CsvTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  static const std::string none;
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return found == columns_.end() ? none
                                 : rows_[row][static_cast<std::size_t>(found - columns_.begin())];
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  return number_of(text(row, column));
}

}  // namespace tocsin::report
