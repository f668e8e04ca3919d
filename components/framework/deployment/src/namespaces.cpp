// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "deployment/running_host.hpp"
#include "foundation/error.hpp"

namespace tocsin::deployment {
namespace {

std::string path_of(const std::string& process, const char* kind) {
  return "/proc/" + process + "/ns/" + kind;
}

bool same_namespace(const std::string& process, const char* kind) {
  struct stat own {};
  struct stat other {};
  return ::stat(path_of("self", kind).c_str(), &own) == 0 &&
         ::stat(path_of(process, kind).c_str(), &other) == 0 && own.st_ino == other.st_ino;
}

/// -1 when this program is in it already.
int open_namespace(const std::string& process, const char* kind) {
  if (same_namespace(process, kind)) return -1;
  const int descriptor = ::open(path_of(process, kind).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  throw EnvironmentError("cannot look into process " + process + ": " +
                         std::system_category().message(errno) + "; run as who launched it");
}

void enter(int descriptor, int kind) {
  if (descriptor < 0) return;
  const bool entered = ::setns(descriptor, kind) == 0;
  const int reason = errno;
  ::close(descriptor);
  if (!entered) {
    throw EnvironmentError("cannot enter the emulated host: " +
                           std::system_category().message(reason) + "; run as who launched it");
  }
}

}  // namespace

void enter_namespaces(pid_t process) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::current_path(ignored);
  const std::string its = std::to_string(process);
  // All are opened first: from inside, /proc may show other processes.
  const int net = open_namespace(its, "net");
  if (net < 0) return;
  const int user = open_namespace(its, "user");
  const int mount = open_namespace(its, "mnt");
  enter(user, CLONE_NEWUSER);
  enter(net, CLONE_NEWNET);
  enter(mount, CLONE_NEWNS);  // the working folder is now /
  std::filesystem::current_path(folder, ignored);
}

}  // namespace tocsin::deployment
