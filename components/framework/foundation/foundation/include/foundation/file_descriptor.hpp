// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <utility>

namespace tocsin {

/// Owns an open file, socket or the like, and closes it.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  /// What a system call has returned; negative: none.
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~FileDescriptor() { reset(); }
  FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    if (this != &other) reset(other.release());
    return *this;
  }

  [[nodiscard]] int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }
  /// Closes it and owns another one, or none.
  void reset(int descriptor = none) {
    const int old = std::exchange(descriptor_, descriptor);
    if (old >= 0) ::close(old);
  }
  /// Gives it away: the caller closes it.
  [[nodiscard]] int release() { return std::exchange(descriptor_, none); }

 private:
  static constexpr int none = -1;
  int descriptor_ = none;
};

}  // namespace tocsin
