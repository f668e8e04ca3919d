// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin::mcap {

/// What a file is read from. Not thread-safe.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// [byte] When it was opened.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// False when not all of these bytes can be read.
  [[nodiscard]] virtual bool read(std::uint64_t offset, std::uint8_t* to, std::size_t size) = 0;
};

class FileSource final : public ByteSource {
 public:
  /// Throws ConfigError when the file cannot be opened.
  explicit FileSource(const std::string& path);
  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] bool read(std::uint64_t offset, std::uint8_t* to, std::size_t size) override;

 private:
  [[nodiscard]] bool read_file(std::uint64_t offset, std::uint8_t* to, std::size_t size) const;

  FileDescriptor file_;
  std::uint64_t size_ = 0;
  std::vector<std::uint8_t> window_;  ///< read ahead, for small records
  std::uint64_t window_at_ = 0;
};

class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::uint8_t* to, std::size_t size) override;

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace tocsin::mcap
