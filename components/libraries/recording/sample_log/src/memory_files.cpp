// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "foundation/error.hpp"
#include "sample_log/log_files.hpp"

namespace tocsin::sample_log {
namespace {

class MemoryFile final : public LogFile {
 public:
  MemoryFile(const MemoryFiles& all, std::shared_ptr<MemoryFiles::Bytes> bytes)
      : all_(all), bytes_(std::move(bytes)) {}

  [[nodiscard]] mcap::Kept append(const std::vector<mcap::Span>& parts) override {
    std::uint64_t size = all_.size();
    for (const mcap::Span& part : parts) size += part.size;
    if (size > all_.room) return mcap::Kept::nothing;
    for (const mcap::Span& part : parts) {
      bytes_->insert(bytes_->end(), part.data, part.data + part.size);
    }
    return mcap::Kept::all;
  }
  void sync() override {}

 private:
  const MemoryFiles& all_;
  const std::shared_ptr<MemoryFiles::Bytes> bytes_;
};

}  // namespace

std::vector<std::string> MemoryFiles::names() const {
  std::vector<std::string> names;
  for (const auto& entry : files_) names.push_back(entry.first);
  return names;
}

std::unique_ptr<LogFile> MemoryFiles::make(const std::string& name) {
  if (refuses_files || files_.count(name) != 0) throw ConfigError(name + ": cannot be made");
  const auto bytes = std::make_shared<Bytes>();
  files_[name] = bytes;
  return std::make_unique<MemoryFile>(*this, bytes);
}

std::unique_ptr<mcap::ByteSource> MemoryFiles::open(const std::string& name) const {
  const auto found = files_.find(name);
  if (found == files_.end()) throw ConfigError(name + ": cannot be read");
  return std::make_unique<mcap::MemorySource>(*found->second);
}

std::uint64_t MemoryFiles::size() const {
  std::uint64_t size = 0;
  for (const auto& entry : files_) size += entry.second->size();
  return size;
}

}  // namespace tocsin::sample_log
