// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace tocsin {

/// What was read from files, kept as long as they have the same size and time of change: a campaign
/// builds the same world a thousand times. Any thread.
///
/// A file that was changed less than two seconds ago is read each time, since the next change might
/// show in neither.
template <class T>
class FileCache {
 public:
  /// What `read()` gives for the file at `path`, or gave before. Throws what it throws.
  template <class Read>
  [[nodiscard]] T get(const std::string& path, const Read& read) {
    const std::optional<Stamp> stamp = stamp_of(path);
    if (!stamp) return read();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = entries_.find(path);
      if (found != entries_.end() && found->second.stamp == *stamp) return found->second.content;
    }
    T content = read();
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_.insert_or_assign(path, Entry{*stamp, content});
    return content;
  }

 private:
  using Stamp = std::pair<std::filesystem::file_time_type, std::uintmax_t>;
  struct Entry {
    Stamp stamp;
    T content;
  };
  static std::optional<Stamp> stamp_of(const std::string& path) {
    std::error_code failed;
    const auto changed = std::filesystem::last_write_time(path, failed);
    if (failed) return std::nullopt;
    const auto age = std::filesystem::file_time_type::clock::now() - changed;
    const std::uintmax_t size = std::filesystem::file_size(path, failed);
    if (failed || age < std::chrono::seconds(2)) return std::nullopt;
    return Stamp{changed, size};
  }
  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

}  // namespace tocsin
