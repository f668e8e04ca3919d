// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace tocsin {

/// A CSV file that only grows: each run appends, the first row names the columns.
class CsvFile {
 public:
  /// Throws ConfigError when the file cannot be opened for writing.
  CsvFile(const std::string& path, const std::vector<std::string>& columns);

  /// Buffered; false when an earlier flush failed.
  bool write(const std::vector<std::string>& cells);
  /// Brings all rows to the file. False when they did not fit (full disk); the next row starts on
  /// a line of its own all the same.
  bool flush();

 private:
  std::ofstream file_;
  std::string path_;
};

}  // namespace tocsin
