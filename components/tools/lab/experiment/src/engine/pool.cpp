// SPDX-License-Identifier: Apache-2.0
#include "engine/pool.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

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

/// All bytes of a small thing; false when the other end is gone.
template <class T>
bool tell(int socket, const T& value) {
  ssize_t sent = 0;
  while ((sent = ::send(socket, &value, sizeof value, MSG_NOSIGNAL)) < 0 && errno == EINTR) {
  }
  return sent == static_cast<ssize_t>(sizeof value);
}

template <class T>
std::optional<T> hear(int socket) {
  T value{};
  ssize_t got = 0;
  while ((got = ::recv(socket, &value, sizeof value, MSG_WAITALL)) < 0 && errno == EINTR) {
  }
  if (got != static_cast<ssize_t>(sizeof value)) return std::nullopt;
  return value;
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Signals wait while it lives.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &both, &before_);
  }
  ~SignalsHeld() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

[[noreturn]] void cannot_start(const char* call) {
  throw EnvironmentError(std::string(call) + ": " + std::strerror(errno));
}

/// What the worker that has just been made does with the signals of its parent, who decides.
void leave_signals_to(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(0);
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
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

std::size_t Pool::busy() const {
  return static_cast<std::size_t>(
      std::count_if(workers_.begin(), workers_.end(),
                    [](const Worker& worker) { return worker.job.has_value(); }));
}

void Pool::start(std::size_t job) {
  Worker& worker = free_worker();
  worker.job = job;
  (void)tell(worker.socket.get(), job);  // of one that has died meanwhile wait() will tell
}

Pool::Worker& Pool::free_worker() {
  const auto found = std::find_if(workers_.begin(), workers_.end(),
                                  [](const Worker& worker) { return !worker.job; });
  return found == workers_.end() ? make_worker() : *found;
}

/// Forks without a program: a worker goes on with the plan and the maps that this process has read.
Pool::Worker& Pool::make_worker() {
  std::fflush(nullptr);
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) cannot_start("socketpair");
  FileDescriptor ours(ends[0]);
  const FileDescriptor theirs(ends[1]);
  const pid_t parent = ::getpid();
  pid_t child = 0;
  {
    const SignalsHeld until_the_child_has_its_own_answers;
    child = ::fork();
    if (child == 0) leave_signals_to(parent);
  }
  if (child == 0) {
    ours.reset();
    workers_.clear();  // or it would never see their end
    work(theirs.get());
  }
  if (child < 0) cannot_start("fork");
  return workers_.emplace_back(Worker{child, std::move(ours), std::nullopt});
}

void Pool::work(int socket) {
  silence_output();
  while (const auto job = hear<std::size_t>(socket)) {
    if (!tell(socket, body_(*job))) break;
  }
  ::_exit(0);
}

Pool::Workers::iterator Pool::next_ready() {
  std::vector<pollfd> sockets;
  for (const Worker& worker : workers_) {
    sockets.push_back({worker.job ? worker.socket.get() : -1, POLLIN, 0});
  }
  if (::poll(sockets.data(), sockets.size(), -1) <= 0) return workers_.end();
  auto worker = workers_.begin();
  for (const pollfd& one : sockets) {
    if (one.revents != 0) return worker;
    ++worker;
  }
  return worker;
}

JobEnd Pool::take(Workers::iterator worker) {
  const std::size_t job = *worker->job;
  const auto code = hear<int>(worker->socket.get());
  if (code) {
    worker->job.reset();
    return {job, *code, 0};
  }
  const int status = wait_for(worker->process);
  workers_.erase(worker);
  return {job, WIFEXITED(status) ? WEXITSTATUS(status) : 0,
          WIFSIGNALED(status) ? WTERMSIG(status) : 0};
}

std::optional<JobEnd> Pool::wait() {
  while (!idle() && !interrupted()) {
    const auto worker = next_ready();
    if (worker == workers_.end()) continue;
    return take(worker);
  }
  return std::nullopt;
}

void Pool::stop() {
  for (Worker& worker : workers_) {
    if (worker.job) ::kill(worker.process, SIGTERM);
    worker.socket.reset();
  }
  for (const Worker& worker : workers_) wait_for(worker.process);
  workers_.clear();
}

}  // namespace tocsin::experiment
