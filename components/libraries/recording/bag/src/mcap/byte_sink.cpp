// SPDX-License-Identifier: Apache-2.0
#include "mcap/byte_sink.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "foundation/error.hpp"

namespace tocsin::mcap {
namespace {

bool write_all(int file, Span part) {
  while (part.size > 0) {
    const ssize_t written = ::write(file, part.data, part.size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    part.data += written;
    part.size -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

FileSink::FileSink(const std::string& path)
    : file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)) {
  if (!file_) throw ConfigError(path + ": cannot be made: " + std::strerror(errno));
}

Kept FileSink::append(const std::vector<Span>& parts) {
  std::uint64_t size = size_;
  for (const Span& part : parts) {
    if (!write_all(file_.get(), part)) {
      // Half a record would hide what is appended behind it.
      const auto before = static_cast<off_t>(size_);
      (void)!::ftruncate(file_.get(), before);
      (void)::lseek(file_.get(), before, SEEK_SET);
      return Kept::nothing;
    }
    size += part.size;
  }
  size_ = size;
  return Kept::all;
}

void FileSink::sync() { (void)::fdatasync(file_.get()); }

Kept MemorySink::append(const std::vector<Span>& parts) {
  for (const Span& part : parts) bytes_.insert(bytes_.end(), part.data, part.data + part.size);
  return Kept::all;
}

}  // namespace tocsin::mcap
