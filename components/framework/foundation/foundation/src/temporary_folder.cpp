// SPDX-License-Identifier: Apache-2.0
#include "foundation/temporary_folder.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

/// Waits in the background, in a session of its own (Ctrl-C does not reach it), for the end of the
/// lifeline. Nobody has to wait for it: its parent ends at once.
constexpr const char* remover =
    R"sh(trap "" HUP TERM; { read -r _; rm -rf -- "$0"; } <&3 3<&- &)sh";

/// Starts the shell with the reading end as its descriptor 3; false when it could not.
bool spawn_remover(const std::string& folder, int reading_end) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, reading_end, 3);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
  }
  ::posix_spawn_file_actions_addclosefrom_np(&actions, 4);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  std::string words[]{"sh", "-c", remover, folder};
  char* arguments[]{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  pid_t shell = -1;
  const int failed = ::posix_spawn(&shell, "/bin/sh", &actions, &attributes, arguments, ::environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  while (failed == 0 && ::waitpid(shell, nullptr, 0) < 0 && errno == EINTR) {
  }
  return failed == 0;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code failed;
  const auto parent = std::filesystem::temp_directory_path(failed);
  std::string name = (failed ? "/tmp" : parent) / "tocsin_XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    throw EnvironmentError(name +
                           ": no folder can be made: " + std::system_category().message(errno));
  }
  path_ = name;
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;  // the destructor alone removes it
  const FileDescriptor reading(ends[0]);
  lifeline_.reset(ends[1]);
  (void)spawn_remover(name, reading.get());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;  // nothing can be done about it here
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name) << text;
  return path(name);
}

std::string TemporaryFolder::write_program(const std::string& name, const std::string& text) const {
  const std::string file = write(name, "#!/bin/sh\n" + text);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

std::string TemporaryFolder::read(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(path_ / name).rdbuf();
  return text.str();
}

}  // namespace tocsin
