// SPDX-License-Identifier: Apache-2.0
#include "container/run_container.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "container/container.hpp"
#include "watch/process_watch.hpp"
#include "watch/resident_memory.hpp"

namespace tocsin {
namespace {

/// Stacks, which the kernel counts whole, and what a process may take before its watchdog looks
/// again.
constexpr double beyond_resident_mib = 2048;

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
  limit_private_memory(
      static_cast<std::uint64_t>((found.health.memory_mib + beyond_resident_mib) * mib));
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
