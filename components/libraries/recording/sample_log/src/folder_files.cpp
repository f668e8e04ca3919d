// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "sample_log/log_files.hpp"

namespace tocsin::sample_log {
namespace {

namespace fs = std::filesystem;

class SyncedFile final : public LogFile {
 public:
  explicit SyncedFile(const std::string& path) : sink_(path) {}
  [[nodiscard]] mcap::Kept append(const std::vector<mcap::Span>& parts) override {
    return sink_.append(parts);
  }
  void sync() override { sink_.sync(); }

 private:
  mcap::FileSink sink_;
};

std::string made(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw ConfigError(folder + ": cannot be made: " + error.message());
  return folder;
}

/// Everything that can go wrong with a folder is one kind of error here.
FolderLock locked(const std::string& folder) {
  try {
    return FolderLock(folder);
  } catch (const EnvironmentError& error) {
    throw ConfigError(error.what());
  }
}

}  // namespace

FolderFiles::FolderFiles(const std::string& folder)
    : folder_(made(folder)), lock_(locked(folder_)), source_(folder_) {}

std::vector<std::string> FolderSource::names() const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    names.push_back(it->path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::unique_ptr<mcap::ByteSource> FolderSource::open(const std::string& name) const {
  return std::make_unique<mcap::FileSource>(folder_ + "/" + name);
}

std::vector<std::string> FolderFiles::names() const { return source_.names(); }

std::unique_ptr<LogFile> FolderFiles::make(const std::string& name) {
  return std::make_unique<SyncedFile>(path(name));
}

std::unique_ptr<mcap::ByteSource> FolderFiles::open(const std::string& name) const {
  return source_.open(name);
}

void FolderFiles::remove(const std::string& name) {
  std::error_code error;
  fs::remove(path(name), error);
}

}  // namespace tocsin::sample_log
