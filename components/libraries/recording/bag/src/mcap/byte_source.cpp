// SPDX-License-Identifier: Apache-2.0
#include "mcap/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "foundation/error.hpp"

namespace tocsin::mcap {
namespace {

constexpr std::size_t window_bytes = 65'536;

bool is_inside(std::uint64_t offset, std::size_t size, std::uint64_t whole) {
  return offset <= whole && size <= whole - offset;
}

}  // namespace

FileSource::FileSource(const std::string& path)
    : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat about {};
  if (!file_ || ::fstat(file_.get(), &about) != 0) {
    throw ConfigError(path + ": cannot be read: " + std::strerror(errno));
  }
  if (!S_ISREG(about.st_mode)) throw ConfigError(path + ": is not a file");
  size_ = static_cast<std::uint64_t>(about.st_size);
}

bool FileSource::read(std::uint64_t offset, std::uint8_t* to, std::size_t size) {
  if (!is_inside(offset, size, size_)) return false;
  if (size >= window_bytes) return read_file(offset, to, size);
  const bool known = offset >= window_at_ && is_inside(offset - window_at_, size, window_.size());
  if (!known) {
    window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(window_bytes, size_ - offset)));
    window_at_ = offset;
    if (!read_file(offset, window_.data(), window_.size())) {
      window_.clear();
      return false;
    }
  }
  if (size > 0) std::memcpy(to, window_.data() + (offset - window_at_), size);
  return true;
}

bool FileSource::read_file(std::uint64_t offset, std::uint8_t* to, std::size_t size) const {
  while (size > 0) {
    const ssize_t got = ::pread(file_.get(), to, size, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    offset += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool MemorySource::read(std::uint64_t offset, std::uint8_t* to, std::size_t size) {
  if (!is_inside(offset, size, bytes_.size())) return false;
  if (size > 0) std::memcpy(to, bytes_.data() + offset, size);
  return true;
}

}  // namespace tocsin::mcap
