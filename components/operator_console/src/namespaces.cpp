// SPDX-License-Identifier: Apache-2.0
#include "namespaces.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin {
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

int open_namespace(const std::string& process, const char* kind) {
  const int descriptor = ::open(path_of(process, kind).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  throw EnvironmentError("cannot look into process " + process + ": " +
                         std::system_category().message(errno) + "; run as who launched it");
}

void enter(int descriptor, int kind) {
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
  const std::string its = std::to_string(process);
  // All are opened first: from inside, /proc may show other processes.
  const int user = same_namespace(its, "user") ? -1 : open_namespace(its, "user");
  const int net = open_namespace(its, "net");
  const int mount = open_namespace(its, "mnt");
  if (user >= 0) enter(user, CLONE_NEWUSER);
  enter(net, CLONE_NEWNET);
  enter(mount, CLONE_NEWNS);
}

}  // namespace tocsin
