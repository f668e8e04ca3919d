// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "csv_tables/message_rows.hpp"

namespace tocsin {

/// A new folder of CSV files: `messages.csv` has a row for each message, `<topic>.csv` (with '.'
/// for '/') the fields of a topic's messages; it is made with the first of them. One thread. What a
/// full disk takes is counted.
class CsvTables {
 public:
  /// Makes the folder. Throws ConfigError when it cannot be made or written.
  explicit CsvTables(std::string folder);

  /// `type` null: only its row of messages.csv is written.
  void write(const RecordedMessage& message, const TypeInfo* type, const void* content);
  /// Rows that did not reach the disk since the beginning.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// Why files of topics could not be made, since the last call; a line each.
  [[nodiscard]] std::vector<std::string> take_problems();

 private:
  void append(std::ofstream& file, const std::vector<std::string>& cells);

  const std::string folder_;
  std::ofstream messages_;
  std::map<std::string, std::ofstream> topics_;
  std::uint64_t lost_ = 0;
  std::vector<std::string> problems_;
};

}  // namespace tocsin
