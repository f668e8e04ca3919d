// SPDX-License-Identifier: Apache-2.0
#include "foundation/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string_view>

namespace tocsin {
namespace {

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_all(int descriptor, std::string_view rest) {
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return last_error();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// Closes in every case; a network file system tells only then that there was no room.
std::error_code write_and_close(int descriptor, const std::string& text, Sync sync) {
  std::error_code error = write_all(descriptor, text);
  if (!error && sync == Sync::yes && ::fsync(descriptor) != 0) error = last_error();
  if (::close(descriptor) != 0 && !error) error = last_error();
  return error;
}

/// A device, a pipe, a terminal: its name must stay what it is.
bool is_special(const std::string& path) {
  struct stat known {};
  return ::stat(path.c_str(), &known) == 0 && !S_ISREG(known.st_mode) && !S_ISDIR(known.st_mode);
}

}  // namespace

std::error_code replace_file(const std::string& path, const std::string& text, Sync sync) {
  if (is_special(path)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    return descriptor < 0 ? last_error() : write_and_close(descriptor, text, Sync::no);
  }
  const std::string fresh = path + ".new";
  const int descriptor = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return last_error();
  std::error_code error = write_and_close(descriptor, text, sync);
  if (!error && std::rename(fresh.c_str(), path.c_str()) != 0) error = last_error();
  if (error) (void)::unlink(fresh.c_str());
  return error;
}

bool is_disk_full(const std::error_code& error) {
  return error == std::errc::no_space_on_device || error.value() == EDQUOT;
}

}  // namespace tocsin
