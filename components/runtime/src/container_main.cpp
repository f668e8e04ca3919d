// SPDX-License-Identifier: Apache-2.0
// tocsin-container FILE HOST CONTAINER: runs one container process of a resolved bringup file.
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <string>

#include "container.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

constexpr int exit_usage = 2;
constexpr int exit_environment = 1;

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

int run(const std::string& file, const std::string& host_name, const std::string& name) {
  const deployment::Deployment deployment = deployment::load_resolved(file);
  const deployment::Host* host = deployment::find_host(deployment, host_name);
  if (host == nullptr) throw ConfigError(file + ": has no host '" + host_name + "'");
  const deployment::Container* found = deployment::find_container(*host, name);
  if (found == nullptr) throw ConfigError(file + ": " + host_name + " has no container " + name);
  const sigset_t signals = block_end_signals();
  std::atomic<int> code{0};
  Container container(deployment, *host, *found, [&code](int wanted) {
    code = wanted;
    kill(getpid(), SIGTERM);
  });
  container.start();
  int received = 0;
  sigwait(&signals, &received);
  return code;
}

int guarded_run(int argc, char** argv) {
  try {
    if (argc != 4) throw ConfigError("usage: tocsin-container FILE HOST CONTAINER");
    return run(argv[1], argv[2], argv[3]);
  } catch (const ConfigError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return exit_usage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return exit_environment;
  }
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) { return tocsin::guarded_run(argc, argv); }
