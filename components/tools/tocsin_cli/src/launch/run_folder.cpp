// SPDX-License-Identifier: Apache-2.0
#include "run_folder.hpp"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/replace_file.hpp"

namespace tocsin::cli {
namespace fs = std::filesystem;
namespace {

/// The C library has no openat2(2).
FileDescriptor open_without_links(const fs::path& folder) {
  open_how how{};
  how.flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
  how.resolve = RESOLVE_NO_SYMLINKS;
  return FileDescriptor(
      static_cast<int>(::syscall(SYS_openat2, AT_FDCWD, folder.c_str(), &how, sizeof how)));
}

bool is_root_s(const FileDescriptor& folder) {
  struct stat found {};
  return ::fstat(folder.get(), &found) == 0 && found.st_uid == 0;
}

}  // namespace

void give_empty_folder(const fs::path& folder) {
  if (folder.empty()) return;
  const FileDescriptor opened = open_without_links(folder);
  if (!opened && errno == ELOOP) {
    throw ConfigError("--run-dir " + folder.string() +
                      ": symbolic links in it; name the folder itself");
  }
  std::error_code ignored;
  if (!opened || !is_root_s(opened) || !fs::is_empty(folder, ignored)) return;
  if (::fchown(opened.get(), ::geteuid(), ::getegid()) != 0) {
    throw EnvironmentError(folder.string() + ": cannot be given to the user of the run");
  }
}

std::error_code write_pids(const fs::path& folder, const std::map<std::string, int>& pids) {
  // Nobody needs it after a loss of power.
  return replace_file(folder / "processes.json", nlohmann::json(pids).dump(2) + "\n", Sync::no);
}

void sweep(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const bool dangling = entry.is_symlink() && !fs::exists(entry.path(), ignored);
    if (entry.is_socket(ignored) || dangling) left.push_back(entry.path());
  }
  for (const fs::path& path : left) fs::remove(path, ignored);
}

}  // namespace tocsin::cli
