// SPDX-License-Identifier: Apache-2.0
#include "foundation/ownership.hpp"

#include <sys/stat.h>
#include <unistd.h>

namespace tocsin {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> place_and_reason(const fs::path& path) {
  const auto reason = changeable_by_others(path);
  if (!reason) return std::nullopt;
  return path.string() + " " + *reason;
}

}  // namespace

std::optional<std::string> changeable_by_others(const FileOwnership& ownership, const User& user) {
  if (ownership.user != 0 && ownership.user != user.id) {
    return "belongs to user " + std::to_string(ownership.user);
  }
  const bool is_sticky = S_ISDIR(ownership.mode) && (ownership.mode & S_ISVTX) != 0;
  if (is_sticky) return std::nullopt;
  if ((ownership.mode & S_IWOTH) != 0) return "may be written by everybody";
  const bool own_group = ownership.group == 0 || ownership.group == user.group;
  if ((ownership.mode & S_IWGRP) != 0 && !own_group) {
    return "may be written by group " + std::to_string(ownership.group);
  }
  return std::nullopt;
}

std::optional<std::string> changeable_by_others(const fs::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  return changeable_by_others({found.st_uid, found.st_gid, found.st_mode},
                              {::geteuid(), ::getegid()});
}

std::optional<std::string> changeable_by_others_below(const fs::path& prefix,
                                                      const fs::path& file) {
  fs::path place = prefix;
  if (auto reason = place_and_reason(place)) return reason;
  for (const fs::path& part : file.lexically_relative(prefix)) {
    place /= part;
    if (auto reason = place_and_reason(place)) return reason;
  }
  std::error_code error;
  const fs::path real = fs::canonical(file, error);  // where links of colcon's lead
  if (error) return std::nullopt;
  return place_and_reason(real.parent_path());
}

}  // namespace tocsin
