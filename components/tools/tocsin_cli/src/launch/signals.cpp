// SPDX-License-Identifier: Apache-2.0
#include "signals.hpp"

#include <signal.h>
#include <sys/signalfd.h>

namespace tocsin::cli {

Signals::Signals() {
  sigset_t wanted;
  ::sigemptyset(&wanted);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) ::sigaddset(&wanted, number);
  ::sigprocmask(SIG_BLOCK, &wanted, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  fd_ = FileDescriptor(::signalfd(-1, &wanted, SFD_NONBLOCK | SFD_CLOEXEC));
}

int Signals::take() {
  signalfd_siginfo info{};
  const bool whole = ::read(fd_.get(), &info, sizeof info) == sizeof info;
  return whole ? static_cast<int>(info.ssi_signo) : 0;
}

}  // namespace tocsin::cli
