// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"

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

/// None when this program is in it already.
FileDescriptor open_namespace(const std::string& process, const char* kind) {
  if (same_namespace(process, kind)) return {};
  FileDescriptor descriptor(::open(path_of(process, kind).c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor) return descriptor;
  throw EnvironmentError("cannot look into process " + process + ": " +
                         std::system_category().message(errno) + "; run as who launched it");
}

[[noreturn]] void fail_to_become(uid_t user) {
  throw EnvironmentError("cannot become user " + std::to_string(user) + ": " +
                         std::system_category().message(errno) + "; run as who launched it");
}

void enter(const FileDescriptor& descriptor, int kind) {
  if (!descriptor || ::setns(descriptor.get(), kind) == 0) return;
  throw EnvironmentError("cannot enter the emulated host: " +
                         std::system_category().message(errno) + "; run as who launched it");
}

/// Becomes, as root, the user of a process: participants hear programs of their own user only.
/// In a user namespace that is its root.
void become_owner(const struct stat& owner, bool in_user_namespace) {
  if (::geteuid() != 0 && !in_user_namespace) return;
  const uid_t user = in_user_namespace ? 0 : owner.st_uid;
  const gid_t group = in_user_namespace ? 0 : owner.st_gid;
  if (user == ::geteuid()) return;
  if (!in_user_namespace && ::setgroups(0, nullptr) != 0) fail_to_become(user);
  if (::setresgid(group, group, group) != 0 || ::setresuid(user, user, user) != 0) {
    fail_to_become(user);
  }
}

}  // namespace

void enter_namespaces(pid_t process) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::current_path(ignored);
  const std::string its = std::to_string(process);
  // All are opened first: from inside, /proc may show other processes.
  const FileDescriptor net = open_namespace(its, "net");
  struct stat owner {};
  if (::stat(("/proc/" + its).c_str(), &owner) != 0) return;  // it has ended
  if (!net) return become_owner(owner, false);
  const FileDescriptor user = open_namespace(its, "user");
  const FileDescriptor mount = open_namespace(its, "mnt");
  enter(user, CLONE_NEWUSER);
  enter(net, CLONE_NEWNET);
  enter(mount, CLONE_NEWNS);  // the working folder is now /
  std::filesystem::current_path(folder, ignored);
  become_owner(owner, static_cast<bool>(user));
}

}  // namespace tocsin::deployment
