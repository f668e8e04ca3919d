// SPDX-License-Identifier: Apache-2.0
#include "leftovers.hpp"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <optional>
#include <set>
#include <string>

namespace tocsin::doctor {
namespace fs = std::filesystem;
namespace {

bool is_of_fast_dds(const std::string& name) {
  constexpr std::array prefixes{"fastrtps_", "sem.fastrtps_", "fast_datasharing_"};
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const char* prefix) { return name.rfind(prefix, 0) == 0; });
}

/// Device and inode: a name may differ between mount namespaces.
using FileId = std::pair<dev_t, ino_t>;

void add_open_files(const fs::path& process, std::set<FileId>& used) {
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(process / "fd", gone)) {
    struct stat status {};
    if (::stat(entry.path().c_str(), &status) == 0) used.insert({status.st_dev, status.st_ino});
  }
}

/// Lines of /proc/PID/maps: "from-to rights offset major:minor inode path", numbers in hex but the
/// inode.
void add_mapped_files(const fs::path& process, std::set<FileId>& used) {
  std::ifstream maps(process / "maps");
  for (std::string line; std::getline(maps, line);) {
    unsigned major = 0;
    unsigned minor = 0;
    unsigned long inode = 0;
    if (std::sscanf(line.c_str(), "%*s %*s %*s %x:%x %lu", &major, &minor, &inode) == 3) {
      used.insert({makedev(major, minor), inode});
    }
  }
}

/// Every file that a process has mapped or open.
std::set<FileId> files_in_use() {
  std::set<FileId> used;
  std::error_code gone;
  for (const auto& process : fs::directory_iterator("/proc", gone)) {
    const std::string name = process.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    add_mapped_files(process.path(), used);
    add_open_files(process.path(), used);
  }
  return used;
}

/// Another user's processes cannot be looked into, so their files are left alone.
bool may_judge(const struct stat& status) {
  return ::geteuid() == 0 || status.st_uid == ::geteuid();
}

struct File {
  fs::path path;
  FileId id;
  std::uintmax_t bytes;
};

/// Empty when it is not there.
std::optional<File> look_at(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !may_judge(status)) return std::nullopt;
  return File{path, {status.st_dev, status.st_ino}, static_cast<std::uintmax_t>(status.st_size)};
}

std::vector<File> files_of_fast_dds(const fs::path& folder) {
  std::vector<File> files;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) {
    const auto file =
        is_of_fast_dds(entry.path().filename()) ? look_at(entry.path()) : std::nullopt;
    if (file) files.push_back(*file);
  }
  return files;
}

}  // namespace

Leftovers find_leftovers(const fs::path& folder) {
  // First which files there are, then who uses them: one that is made meanwhile is nobody's
  // leftover, and one that goes meanwhile neither.
  const std::vector<File> files = files_of_fast_dds(folder);
  const std::set<FileId> used = files_in_use();
  Leftovers leftovers;
  for (const File& file : files) {
    const auto now = look_at(file.path);
    if (!now || now->id != file.id || used.count(file.id) != 0) continue;
    leftovers.files.push_back(file.path);
    leftovers.bytes += file.bytes;
  }
  std::sort(leftovers.files.begin(), leftovers.files.end());
  return leftovers;
}

std::size_t remove(const Leftovers& leftovers) {
  std::error_code refused;
  return static_cast<std::size_t>(
      std::count_if(leftovers.files.begin(), leftovers.files.end(),
                    [&](const fs::path& file) { return fs::remove(file, refused); }));
}

}  // namespace tocsin::doctor
