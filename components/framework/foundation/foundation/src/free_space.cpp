// SPDX-License-Identifier: Apache-2.0
#include "foundation/free_space.hpp"

#include <sys/statvfs.h>
#include <unistd.h>

namespace tocsin {
namespace {

struct Room {
  std::uint64_t free_blocks = 0;
  std::uint64_t blocks = 0;
  std::uint64_t block_bytes = 0;
};

std::optional<Room> room_on(const std::string& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0 || disk.f_blocks == 0) return std::nullopt;
  const bool root = ::geteuid() == 0;  // may use what is kept back from the others
  const bool has_files = disk.f_files == 0 || (root ? disk.f_ffree : disk.f_favail) > 0;
  const std::uint64_t free = root ? disk.f_bfree : disk.f_bavail;
  return Room{has_files ? free : 0, disk.f_blocks, disk.f_frsize};
}

}  // namespace

std::optional<std::uint64_t> free_bytes(const std::string& folder) {
  const auto room = room_on(folder);
  if (!room) return std::nullopt;
  return room->free_blocks * room->block_bytes;
}

std::optional<double> free_share(const std::string& folder) {
  const auto room = room_on(folder);
  if (!room) return std::nullopt;
  return static_cast<double>(room->free_blocks) / static_cast<double>(room->blocks);
}

}  // namespace tocsin
