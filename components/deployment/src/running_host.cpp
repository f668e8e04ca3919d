// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "foundation/error.hpp"
#include "foundation/yaml_file.hpp"

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

pid_t process_of(const std::string& run_dir, const std::string& host) {
  const std::string file = run_dir + "/processes.json";
  if (std::filesystem::exists(file)) {
    for (const auto& entry : read_yaml_file(file)) {
      const auto pid = entry.second.as<pid_t>(0);
      const bool ours = entry.first.Scalar().rfind(host + "/", 0) == 0;
      if (ours && pid > 0 && ::kill(pid, 0) == 0) return pid;
    }
  }
  throw EnvironmentError("nothing runs on host " + host + " of " + run_dir);
}

void enter_namespaces(pid_t process) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::current_path(ignored);
  const std::string its = std::to_string(process);
  // All are opened first: from inside, /proc may show other processes.
  const int user = same_namespace(its, "user") ? -1 : open_namespace(its, "user");
  const int net = open_namespace(its, "net");
  const int mount = open_namespace(its, "mnt");
  if (user >= 0) enter(user, CLONE_NEWUSER);
  enter(net, CLONE_NEWNET);
  enter(mount, CLONE_NEWNS);  // the working folder is now /
  std::filesystem::current_path(folder, ignored);
}

}  // namespace tocsin::deployment
