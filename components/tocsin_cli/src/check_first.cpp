// SPDX-License-Identifier: Apache-2.0
#include "check_first.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "foundation/error.hpp"

namespace tocsin::cli {
namespace {

/// Runs a program on this terminal and returns its exit code; 128 and more for a signal.
int run(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t child = -1;
  const int error = ::posix_spawn(&child, words[0], nullptr, nullptr, words.data(), environ);
  if (error != 0) throw EnvironmentError(command[0] + ": " + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

bool check_first(const BringupOptions& options, const Folders& folders) {
  const auto program = find_program("tocsin-check", folders);
  if (!program) throw ConfigError("tocsin-check is not found beside tocsin-launch or in $PATH");
  std::vector<std::string> command = options.arguments();
  command.insert(command.begin(), {program->string(), "--quiet"});
  return run(command) == 0;
}

}  // namespace tocsin::cli
