// SPDX-License-Identifier: Apache-2.0
#include "foundation/read_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw ConfigError(path + ": " + what);
}

}  // namespace

std::string read_file(const std::string& path, std::size_t longest) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) fail(path, "cannot be read: " + std::system_category().message(errno));
  std::string bytes;
  std::array<char, 65536> part;
  ssize_t got = 0;
  do {
    got = ::read(file.get(), part.data(), part.size());
    if (got > 0) bytes.append(part.data(), static_cast<std::size_t>(got));
  } while ((got > 0 && bytes.size() <= longest) || (got < 0 && errno == EINTR));
  if (got < 0) fail(path, "cannot be read: " + std::system_category().message(errno));
  if (bytes.size() > longest) fail(path, "has more than " + std::to_string(longest) + " bytes");
  return bytes;
}

}  // namespace tocsin
