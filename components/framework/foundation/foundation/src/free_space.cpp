// SPDX-License-Identifier: Apache-2.0
#include "foundation/free_space.hpp"

#include <sys/statvfs.h>
#include <unistd.h>

namespace tocsin {

std::optional<std::uint64_t> free_bytes(const std::string& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0 || disk.f_blocks == 0) return std::nullopt;
  const bool root = ::geteuid() == 0;  // may use what is kept back from the others
  const bool has_files = disk.f_files == 0 || (root ? disk.f_ffree : disk.f_favail) > 0;
  if (!has_files) return 0;
  return std::uint64_t{root ? disk.f_bfree : disk.f_bavail} * disk.f_frsize;
}

}  // namespace tocsin
