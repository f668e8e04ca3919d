// SPDX-License-Identifier: Apache-2.0
#include "foundation/child_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

/// Ends the child; only async-signal-safe calls from here on.
[[noreturn]] void give_up(const char* what) {
  const char* reason = ::strerrordesc_np(errno);
  for (const char* text : {what, ": ", reason, "\n"}) {
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) break;
  }
  ::_exit(127);
}

void die_with_parent(int signal, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, signal);
  if (::getppid() != parent) ::_exit(127);  // it died before the call
}

void connect_output(int pipe_end, ChildSetup::Streams streams) {
  if (streams == ChildSetup::Streams::piped) {
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(pipe_end, STDOUT_FILENO);
  }
  ::dup2(pipe_end, STDERR_FILENO);
}

void reset_signals() {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM}) ::signal(number, SIG_DFL);
}

[[noreturn]] void become(const ChildSetup& setup, char* const* arguments, int pipe_end,
                         pid_t parent) {
  die_with_parent(setup.death_signal, parent);
  if (setup.streams != ChildSetup::Streams::ours) {
    ::setpgid(0, 0);
    connect_output(pipe_end, setup.streams);
  }
  reset_signals();
  for (const int fd : setup.inherited) ::fcntl(fd, F_SETFD, 0);
  if (setup.network && (!wake_capabilities() || ::setns(*setup.network, CLONE_NEWNET) != 0)) {
    give_up("cannot enter the network namespace");
  }
  if (!pass_on_capabilities(setup.capabilities)) give_up("cannot pass on capabilities");
  ::execv(arguments[0], arguments);
  give_up(arguments[0]);
}

}  // namespace

Child start_child(const ChildSetup& setup) {
  std::vector<char*> arguments;
  for (const std::string& word : setup.command) arguments.push_back(const_cast<char*>(word.data()));
  arguments.push_back(nullptr);
  const bool is_piped = setup.streams != ChildSetup::Streams::ours;
  int ends[2] = {-1, -1};  // none
  if (is_piped && ::pipe2(ends, O_CLOEXEC) != 0) throw EnvironmentError("cannot make a pipe");
  Child child{-1, FileDescriptor(ends[0])};
  const FileDescriptor write_end(ends[1]);
  if (is_piped) ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const pid_t parent = ::getpid();
  child.pid = ::fork();
  if (child.pid < 0) throw EnvironmentError("cannot start a process: fork failed");
  if (child.pid == 0) become(setup, arguments.data(), ends[1], parent);
  if (is_piped)
    ::setpgid(child.pid, child.pid);  // also here, so that it holds before the child has run
  return child;
}

int wait_for_child(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace tocsin
