// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "csv_tables/csv_file.hpp"
#include "csv_tables/message_rows.hpp"

namespace tocsin {

/// A folder of CSV files: `messages.csv` has a row for each message, `<topic>.csv` (with '.' for
/// '/') the fields of a topic's messages; it is made with the first of them. One thread. What a
/// full disk takes is counted.
class CsvTables {
 public:
  /// Makes the folder. Throws ConfigError when it cannot be made or written.
  explicit CsvTables(std::string folder);

  /// `type` null: only its row of messages.csv is written.
  void write(const RecordedMessage& message, const TypeInfo* type, const void* content);
  void flush();
  /// Rows that did not reach the disk since the beginning.
  [[nodiscard]] std::uint64_t lost() const;
  /// Why files of topics could not be made, since the last call; a line each.
  [[nodiscard]] std::vector<std::string> take_problems();

 private:
  /// Null: it could not be made.
  CsvFile* file_of(const std::string& topic, const std::vector<std::string>& columns);

  const std::string folder_;
  std::unique_ptr<CsvFile> messages_;
  std::map<std::string, std::unique_ptr<CsvFile>> topics_;
  std::vector<std::string> problems_;
};

}  // namespace tocsin
