// SPDX-License-Identifier: Apache-2.0
#include "safety_controller/stop_file.hpp"

#include <unistd.h>

#include <sstream>

namespace tocsin {

StopFile::Memory StopFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  pid_t parent = 0;
  Memory memory;
  text >> parent >> memory.station >> memory.others;
  return text && parent == ::getppid() ? memory : Memory{};
}

bool StopFile::save(const Memory& memory) {
  const bool same = saved_ && saved_->station == memory.station && saved_->others == memory.others;
  if (same || !file_.keeps()) return true;
  std::ostringstream text;
  text << ::getppid() << ' ' << memory.station << ' ' << memory.others;
  const bool had_failed = failed_;
  failed_ = !file_.save(text.str());
  if (!failed_) saved_ = memory;
  return !failed_ || had_failed;
}

}  // namespace tocsin
