// SPDX-License-Identifier: Apache-2.0
#include "container/run_container.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "container/container.hpp"

namespace tocsin {
namespace {

/// Blocks the signals that end the process, in this and all later threads.
sigset_t block_end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal(SIGPIPE, SIG_IGN);
  return signals;
}

}  // namespace

int run_container(const deployment::Deployment& deployment, const deployment::Host& host,
                  const deployment::Container& found) {
  const sigset_t signals = block_end_signals();
  std::atomic<int> code{0};
  Container container(deployment, host, found, [&code](int wanted) {
    code = wanted;
    kill(getpid(), SIGTERM);
  });
  container.start();
  int received = 0;
  sigwait(&signals, &received);
  return code;
}

}  // namespace tocsin
