// SPDX-License-Identifier: Apache-2.0
#include "foundation/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (!folder_) {
    throw EnvironmentError(folder.string() +
                           ": cannot be opened: " + std::generic_category().message(errno));
  }
  if (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw ConfigError(folder.string() + ": another run is using it");
  }
}

}  // namespace tocsin
