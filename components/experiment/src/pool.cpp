// SPDX-License-Identifier: Apache-2.0
#include "pool.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::experiment {
namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void on_interrupt(int) { interrupt_seen = 1; }

/// The logs of a thousand runs are nobody's reading; what failed is in the results.
void silence_output() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

}  // namespace

Pool::Pool(int at_a_time, std::function<int(std::size_t)> body)
    : at_a_time_(static_cast<std::size_t>(at_a_time)), body_(std::move(body)) {
  interrupt_seen = 0;
  struct sigaction action {};
  action.sa_handler = on_interrupt;  // without SA_RESTART: waitpid shall return
  ::sigaction(SIGINT, &action, &old_int_);
  ::sigaction(SIGTERM, &action, &old_term_);
}

Pool::~Pool() {
  stop();
  ::sigaction(SIGINT, &old_int_, nullptr);
  ::sigaction(SIGTERM, &old_term_, nullptr);
}

bool Pool::interrupted() const { return interrupt_seen != 0; }

void Pool::start(std::size_t job) {
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  // Until the child has its own answers to them, signals wait.
  sigset_t both;
  sigset_t before;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &both, &before);
  const pid_t child = ::fork();
  if (child != 0) ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw EnvironmentError(std::string("fork: ") + std::strerror(errno));
  if (child > 0) {
    running_[child] = job;
    return;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(0);
  std::signal(SIGINT, SIG_IGN);  // the parent decides
  std::signal(SIGTERM, SIG_DFL);
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  silence_output();
  ::_exit(body_(job));
}

bool Pool::wait(JobEnd& end) {
  while (!running_.empty() && !interrupted()) {
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    const auto found = running_.find(child);
    if (child < 0 || found == running_.end()) continue;
    end = {found->second, WIFEXITED(status) ? WEXITSTATUS(status) : 0,
           WIFSIGNALED(status) ? WTERMSIG(status) : 0};
    running_.erase(found);
    return true;
  }
  return false;
}

void Pool::stop() {
  for (const auto& [child, job] : running_) ::kill(child, SIGTERM);
  for (const auto& [child, job] : running_) {
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  running_.clear();
}

}  // namespace tocsin::experiment
