// SPDX-License-Identifier: Apache-2.0
#include "command_line/run_to_end.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin {
namespace {

/// A file in memory that holds a text, to be read from its beginning: unlike a pipe it takes
/// everything at once, and nobody is killed when it is not read.
FileDescriptor holding(const std::string& text) {
  FileDescriptor file(::memfd_create("tocsin_input", MFD_CLOEXEC));
  std::size_t written = 0;
  while (file && written < text.size()) {
    const ssize_t some = ::write(file.get(), text.data() + written, text.size() - written);
    if (some < 0 && errno == EINTR) continue;
    if (some <= 0) throw EnvironmentError("no memory for the input of a program");
    written += static_cast<std::size_t>(some);
  }
  if (!file || ::lseek(file.get(), 0, SEEK_SET) != 0) {
    throw EnvironmentError("no memory for the input of a program");
  }
  return file;
}

/// What posix_spawn does in the child before the program.
class Actions {
 public:
  Actions(int input, int output, const std::string& folder) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
    if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~Actions() { ::posix_spawn_file_actions_destroy(&actions_); }
  Actions(const Actions&) = delete;
  Actions& operator=(const Actions&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Starts it with both outputs in `output`.
pid_t start(const std::vector<std::string>& command, const ProgramInput& input,
            const FileDescriptor& output) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const FileDescriptor text = holding(input.text);
  const Actions actions(text.get(), output.get(), input.folder);
  pid_t child = -1;
  const int error = ::posix_spawnp(&child, words[0], actions.get(), nullptr, words.data(), environ);
  if (error != 0) throw EnvironmentError(command[0] + ": " + std::strerror(error));
  return child;
}

std::string read_all(const FileDescriptor& source) {
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t size = ::read(source.get(), block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

Ended run_to_end(const std::vector<std::string>& command, const ProgramInput& input) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw EnvironmentError("cannot make a pipe");
  const FileDescriptor reading(ends[0]);
  FileDescriptor writing(ends[1]);
  const pid_t child = start(command, input, writing);
  writing.reset();
  Ended ended;
  ended.output = read_all(reading);
  ended.code = wait_for_child(child);
  return ended;
}

}  // namespace tocsin
