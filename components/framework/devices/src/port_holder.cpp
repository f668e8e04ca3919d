// SPDX-License-Identifier: Apache-2.0
#include "port_holder.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace tocsin {
namespace {

namespace fs = std::filesystem;

bool is_process(const fs::path& folder) {
  const std::string name = folder.filename();
  return !name.empty() && std::all_of(name.begin(), name.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool has_open(const fs::path& process, const fs::path& device) {
  std::error_code error;
  for (fs::directory_iterator it(process / "fd", error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;  // it may have been closed meanwhile
    if (fs::read_symlink(it->path(), ignored) == device) return true;
  }
  return false;
}

std::string describe(const fs::path& process) {
  std::string name;
  std::getline(std::ifstream(process / "comm"), name);
  return name + " (pid " + process.filename().string() + ")";
}

}  // namespace

std::optional<std::string> holder_of(const std::string& path) {
  std::error_code error;
  const fs::path device = fs::canonical(path, error);
  if (error) return std::nullopt;
  const std::string own = std::to_string(::getpid());
  for (fs::directory_iterator it("/proc", error), end; !error && it != end; it.increment(error)) {
    if (!is_process(it->path()) || it->path().filename() == own) continue;
    if (has_open(it->path(), device)) return describe(it->path());
  }
  return std::nullopt;
}

}  // namespace tocsin
