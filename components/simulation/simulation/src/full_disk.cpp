// SPDX-License-Identifier: Apache-2.0
#include "full_disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace tocsin::simulation {
namespace {

namespace fs = std::filesystem;

/// Descriptors of this process that append to files under `folder`.
std::vector<int> appending_under(const std::string& folder) {
  std::error_code failed;
  const std::string begin = fs::weakly_canonical(folder, failed).string() + "/";
  std::vector<int> found;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd", failed)) {
    const std::string file = fs::read_symlink(entry.path(), failed).string();
    if (failed || file.compare(0, begin.size(), begin) != 0) continue;
    const int descriptor = std::stoi(entry.path().filename().string());
    const int flags = ::fcntl(descriptor, F_GETFL);
    if (flags >= 0 && (flags & O_APPEND) != 0) found.push_back(descriptor);
  }
  return found;
}

/// A component may have closed its file meanwhile, and another world have opened one of that
/// number.
bool is_full(int descriptor) {
  struct stat full {};
  struct stat own {};
  return ::stat("/dev/full", &full) == 0 && ::fstat(descriptor, &own) == 0 &&
         S_ISCHR(own.st_mode) && own.st_rdev == full.st_rdev;
}

}  // namespace

FullDisk::FullDisk(const std::string& folder) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (full < 0) return;
  for (const int descriptor : appending_under(folder)) {
    const int real = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
    if (real < 0) continue;
    files_.push_back({descriptor, real});
    ::dup3(full, descriptor, O_CLOEXEC);
  }
  ::close(full);
}

FullDisk::~FullDisk() {
  for (const File& file : files_) {
    if (is_full(file.descriptor)) ::dup3(file.real, file.descriptor, O_CLOEXEC);
    ::close(file.real);
  }
}

}  // namespace tocsin::simulation
