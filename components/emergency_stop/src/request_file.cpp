// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/request_file.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace tocsin {

std::optional<bool> RequestFile::load() const {
  std::ifstream file(path_);
  pid_t parent = 0;
  std::string word;
  file >> parent >> word;
  if (!file || parent != ::getppid() || (word != "on" && word != "off")) return std::nullopt;
  return word == "on";
}

bool RequestFile::save(bool pressed) const {
  if (path_.empty()) return true;
  const std::string fresh = path_ + ".new";
  {
    std::ofstream file(fresh);
    file << ::getppid() << ' ' << (pressed ? "on" : "off") << '\n';
    if (!file.flush()) return false;
  }
  return std::rename(fresh.c_str(), path_.c_str()) == 0;
}

}  // namespace tocsin
