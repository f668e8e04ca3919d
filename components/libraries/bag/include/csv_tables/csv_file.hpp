// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// A CSV file that only grows: each run appends, the first row names the columns.
class CsvFile {
 public:
  /// Throws ConfigError when the file cannot be opened for writing.
  CsvFile(const std::string& path, const std::vector<std::string>& columns);
  /// Flushes.
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  /// Keeps the row until the next flush, or flushes when many wait.
  void write(const std::vector<std::string>& cells);
  /// Brings all rows to the file. False when they did not fit (full disk): they are lost, and the
  /// next row starts on a line of its own all the same.
  bool flush();
  /// Rows that did not fit, since the beginning.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  FileDescriptor file_;
  std::string waiting_;
  bool is_cut_ = false;  ///< the file ends in the middle of a row
  std::uint64_t lost_ = 0;
};

}  // namespace tocsin
