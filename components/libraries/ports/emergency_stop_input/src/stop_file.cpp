// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/stop_file.hpp"

#include <unistd.h>

#include <sstream>

namespace tocsin {
namespace {

bool same(const StopMemory& a, const StopMemory& b) {
  return a.latch.station == b.latch.station && a.latch.others == b.latch.others &&
         a.link.stands == b.link.stands && a.link.expects == b.link.expects;
}

}  // namespace

StopMemory StopFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  pid_t parent = 0;
  StopMemory memory;
  text >> parent >> memory.latch.station >> memory.latch.others >> memory.link.stands >>
      memory.link.expects;
  return text && parent == ::getppid() ? memory : StopMemory{};
}

bool StopFile::save(const StopMemory& memory) {
  if ((saved_ && same(*saved_, memory)) || !file_.keeps()) return true;
  std::ostringstream text;
  text << ::getppid() << ' ' << memory.latch.station << ' ' << memory.latch.others << ' '
       << memory.link.stands << ' ' << memory.link.expects;
  const bool had_failed = failed_;
  failed_ = !file_.save(text.str());
  if (!failed_) saved_ = memory;
  return !failed_ || had_failed;
}

}  // namespace tocsin
