// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/folder_lock.hpp"
#include "mcap/byte_sink.hpp"
#include "mcap/byte_source.hpp"

namespace tocsin::sample_log {

/// A file of a log that is being written; what was appended survives that the process is killed.
class LogFile : public mcap::ByteSink {
 public:
  /// From then on it also survives that the computer loses its power. May block for long.
  virtual void sync() = 0;
};

/// The files of one log, to be read, also while another process writes them. One thread at a time.
class LogSource {
 public:
  virtual ~LogSource() = default;
  /// Sorted.
  [[nodiscard]] virtual std::vector<std::string> names() const = 0;
  /// Throws ConfigError when it cannot be read. Reads what the file has at that time.
  [[nodiscard]] virtual std::unique_ptr<mcap::ByteSource> open(const std::string& name) const = 0;
};

/// The files of one log. One thread at a time.
class LogFiles : public LogSource {
 public:
  /// Throws ConfigError when it is there already or cannot be made.
  [[nodiscard]] virtual std::unique_ptr<LogFile> make(const std::string& name) = 0;
  virtual void remove(const std::string& name) = 0;
};

/// The files of a folder that another process may have. A folder that is not there has none.
class FolderSource final : public LogSource {
 public:
  explicit FolderSource(std::string folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::vector<std::string> names() const override;
  [[nodiscard]] std::unique_ptr<mcap::ByteSource> open(const std::string& name) const override;

 private:
  const std::string folder_;
};

/// The files of a folder, which is this process's as long as this lives.
class FolderFiles final : public LogFiles {
 public:
  /// Makes the folder. Throws ConfigError when it cannot be made or another process has it.
  explicit FolderFiles(const std::string& folder);
  [[nodiscard]] std::vector<std::string> names() const override;
  [[nodiscard]] std::unique_ptr<LogFile> make(const std::string& name) override;
  [[nodiscard]] std::unique_ptr<mcap::ByteSource> open(const std::string& name) const override;
  void remove(const std::string& name) override;

 private:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }
  const std::string folder_;
  FolderLock lock_;
  const FolderSource source_;
};

/// Files in memory, for tests: they outlive the log that writes them, as files do.
class MemoryFiles final : public LogFiles {
 public:
  using Bytes = std::vector<std::uint8_t>;
  [[nodiscard]] std::vector<std::string> names() const override;
  [[nodiscard]] std::unique_ptr<LogFile> make(const std::string& name) override;
  [[nodiscard]] std::unique_ptr<mcap::ByteSource> open(const std::string& name) const override;
  void remove(const std::string& name) override { files_.erase(name); }

  /// Of a file that is there; a test may damage it.
  [[nodiscard]] Bytes& bytes_of(const std::string& name) { return *files_.at(name); }
  [[nodiscard]] std::uint64_t size() const;
  /// [byte] All files together can have; beyond it nothing is taken.
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();
  bool refuses_files = false;  ///< no file can be made

 private:
  std::map<std::string, std::shared_ptr<Bytes>> files_;
};

}  // namespace tocsin::sample_log
