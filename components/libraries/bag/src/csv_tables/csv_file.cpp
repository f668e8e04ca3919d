// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/csv_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "csv_tables/message_rows.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_waiting = 65536;  // [byte]

/// A process that was killed may have left half a row behind.
bool ends_with_newline(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || file.tellg() == 0) return true;
  file.seekg(-1, std::ios::end);
  return file.get() == '\n';
}

}  // namespace

CsvFile::CsvFile(const std::string& path, const std::vector<std::string>& columns)
    : file_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644)) {
  if (!file_) throw ConfigError(path + ": cannot be written: " + std::strerror(errno));
  std::error_code none;
  is_cut_ = !ends_with_newline(path);
  if (std::filesystem::file_size(path, none) == 0 || none) waiting_ = csv_line(columns);
}

CsvFile::~CsvFile() { (void)flush(); }

void CsvFile::write(const std::vector<std::string>& cells) {
  waiting_ += csv_line(cells);
  if (waiting_.size() >= most_waiting) (void)flush();
}

bool CsvFile::flush() {
  if (waiting_.empty()) return true;
  if (is_cut_) waiting_.insert(waiting_.begin(), '\n');
  std::string_view rest = waiting_;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    rest.remove_prefix(static_cast<std::size_t>(written));
    is_cut_ = *(rest.data() - 1) != '\n';
  }
  if (!rest.empty() && rest.size() == waiting_.size() && is_cut_) rest.remove_prefix(1);
  lost_ += static_cast<std::uint64_t>(std::count(rest.begin(), rest.end(), '\n'));
  const bool fitted = rest.empty();
  waiting_.clear();
  return fitted;
}

}  // namespace tocsin
