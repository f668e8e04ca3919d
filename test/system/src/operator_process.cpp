// SPDX-License-Identifier: Apache-2.0
#include "operator_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include "stack.hpp"

namespace tocsin {

OperatorProcess::OperatorProcess(const std::vector<std::string>& words, const std::string& output) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) {
    setpgid(0, 0);
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(ends[0], STDIN_FILENO);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(127);
  }
  close(ends[0]);
  input_ = ends[1];
}

OperatorProcess::~OperatorProcess() {
  kill_all();
  close(input_);
  (void)exit_code(std::chrono::seconds(5));
}

void OperatorProcess::type(const std::string& keys) const {
  if (write(input_, keys.data(), keys.size()) < 0) throw std::runtime_error("cannot type");
}

void OperatorProcess::kill_all() const {
  if (pid_ > 0) kill(-pid_, SIGKILL);
}

void OperatorProcess::end_all() {
  if (pid_ > 0) kill(-pid_, SIGTERM);
  (void)exit_code(std::chrono::seconds(10));
}

int OperatorProcess::exit_code(std::chrono::seconds limit) {
  (void)Stack::eventually(limit, [this] {
    int status = 0;
    if (pid_ > 0 && waitpid(pid_, &status, WNOHANG) == pid_) {
      code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      pid_ = -1;
    }
    return pid_ <= 0;
  });
  return code_;
}

}  // namespace tocsin
