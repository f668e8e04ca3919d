// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin::mcap {

/// Bytes that belong to somebody else.
struct Span {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

/// What became of bytes that were to be kept.
enum class Kept {
  all,
  nothing  ///< a full disk; the file ends where it ended before
};

/// Where a file is written to.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Appends all parts, or nothing.
  [[nodiscard]] virtual Kept append(const std::vector<Span>& parts) = 0;
};

class FileSink final : public ByteSink {
 public:
  /// Makes the file. Throws ConfigError when it cannot be made, and when it is there already.
  explicit FileSink(const std::string& path);
  [[nodiscard]] Kept append(const std::vector<Span>& parts) override;
  /// What was appended survives a power cut from then on. May block as long as the disk takes.
  void sync();

 private:
  FileDescriptor file_;
  std::uint64_t size_ = 0;
};

class MemorySink final : public ByteSink {
 public:
  [[nodiscard]] Kept append(const std::vector<Span>& parts) override;
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace tocsin::mcap
