// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/shared_memory_leftovers.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace tocsin {
namespace {

constexpr std::string_view prefix = "fastrtps_";
constexpr std::string_view lock_suffix = "_el";  // held by flock as long as the owner lives

bool is_lock(const std::string& name) {
  return name.size() > prefix.size() + lock_suffix.size() &&
         name.compare(0, prefix.size(), prefix) == 0 &&
         name.compare(name.size() - lock_suffix.size(), lock_suffix.size(), lock_suffix) == 0;
}

/// Holds the lock of a dead owner, so that nobody else takes its files for living ones.
bool remove_if_dead(const std::filesystem::path& lock) {
  const int fd = open(lock.c_str(), O_RDWR | O_CLOEXEC);
  if (fd < 0) return false;
  const bool dead = flock(fd, LOCK_EX | LOCK_NB) == 0;
  if (dead) {
    const std::string name = lock.filename().string();
    const std::string owner = name.substr(0, name.size() - lock_suffix.size());
    for (const std::string& file : {owner, "sem." + owner + "_mutex", name}) {
      unlink((lock.parent_path() / file).c_str());
    }
  }
  close(fd);
  return dead;
}

}  // namespace

int remove_shared_memory_leftovers(const std::string& folder) {
  std::vector<std::filesystem::path> locks;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; at != end && !error;
       at.increment(error)) {
    if (is_lock(at->path().filename().string())) locks.push_back(at->path());
  }
  int removed = 0;
  for (const std::filesystem::path& lock : locks) removed += remove_if_dead(lock) ? 1 : 0;
  return removed;
}

}  // namespace tocsin
