// SPDX-License-Identifier: Apache-2.0
#include "pseudo_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <termios.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw EnvironmentError("pseudo-terminal: " + what + ": " + std::strerror(errno));
}

FileDescriptor open_master() {
  FileDescriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!master) fail("cannot open /dev/ptmx");
  if (::grantpt(master.get()) != 0 || ::unlockpt(master.get()) != 0) fail("cannot unlock");
  return master;
}

/// Raw 115200 baud. Opened and closed once so that `in_use` can tell that nobody is there.
void prepare_slave(const std::string& name) {
  const FileDescriptor slave(::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!slave) fail("cannot open " + name);
  termios settings{};
  ::tcgetattr(slave.get(), &settings);
  ::cfmakeraw(&settings);
  ::cfsetspeed(&settings, B115200);
  ::tcsetattr(slave.get(), TCSANOW, &settings);
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::string link) : link_(std::move(link)) {
  struct stat found {};
  if (::lstat(link_.c_str(), &found) == 0 && !S_ISLNK(found.st_mode)) {
    throw ConfigError("--link: " + link_ + " exists and is not a symbolic link");
  }
  renew();
}

PseudoTerminal::~PseudoTerminal() { remove(); }

void PseudoTerminal::renew() {
  master_ = open_master();
  char name[64] = {};
  if (::ptsname_r(master_.get(), name, sizeof name) != 0) fail("has no name");
  prepare_slave(name);
  const std::string fresh = link_ + ".new";
  ::unlink(fresh.c_str());
  if (::symlink(name, fresh.c_str()) != 0) fail("cannot create " + fresh);
  if (std::rename(fresh.c_str(), link_.c_str()) != 0) fail("cannot create " + link_);
}

void PseudoTerminal::remove() {
  if (!master_) return;
  ::unlink(link_.c_str());
  master_.reset();
}

bool PseudoTerminal::in_use() const {
  pollfd asked{master_.get(), 0, 0};
  return master_ && ::poll(&asked, 1, 0) >= 0 && (asked.revents & POLLHUP) == 0;
}

void PseudoTerminal::send(ByteView bytes) {
  if (!in_use()) return;
  [[maybe_unused]] const auto written = ::write(master_.get(), bytes.data, bytes.size);
}

std::size_t PseudoTerminal::receive(std::uint8_t* to, std::size_t size) {
  const auto count = ::read(master_.get(), to, size);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace tocsin::kobuki
