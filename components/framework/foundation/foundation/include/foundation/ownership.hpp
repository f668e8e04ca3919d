// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

namespace tocsin {

/// What decides who may change a file or a folder.
struct FileOwnership {
  uid_t user = 0;
  gid_t group = 0;
  mode_t mode = 0;
};
/// Who uses it.
struct User {
  uid_t id = 0;
  gid_t group = 0;
};

/// Why somebody else than `user` and root may change it: "belongs to user 1001", "may be written
/// by everybody"; nothing when nobody may. The user's own group is trusted, as Debian gives each
/// user one. In a folder such as /tmp (sticky) only the owner of an entry may change it.
[[nodiscard]] std::optional<std::string> changeable_by_others(const FileOwnership& ownership,
                                                              const User& user);

/// The same of what is at `path`, symbolic links followed, for this process; nothing when nothing
/// is there.
[[nodiscard]] std::optional<std::string> changeable_by_others(const std::filesystem::path& path);

/// The same of a file below `prefix` and of the folders from there to it, with the path that is the
/// cause: "/opt/x/lib may be written by everybody". What lies above the prefix is not looked at:
/// who put it there answers for it.
[[nodiscard]] std::optional<std::string> changeable_by_others_below(
    const std::filesystem::path& prefix, const std::filesystem::path& file);

}  // namespace tocsin
