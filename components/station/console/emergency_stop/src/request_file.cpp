// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/request_file.hpp"

#include <unistd.h>

#include <sstream>

namespace tocsin {

bool RequestFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  pid_t parent = 0;
  std::string word;
  text >> parent >> word;
  return text && parent == ::getppid() && word == "on";
}

bool RequestFile::save(bool pressed) {
  return file_.save(std::to_string(::getppid()) + (pressed ? " on" : " off"));
}

}  // namespace tocsin
