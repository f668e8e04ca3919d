// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::deployment {
namespace {

namespace fs = std::filesystem;

constexpr const char* container_program = "tocsin-container";

std::string own_descriptor(const FileDescriptor& file) {
  return "/proc/self/fd/" + std::to_string(file.get());
}

/// A process that runs tocsin-container FILE HOST CONTAINER [COPY].
struct ContainerProcess {
  pid_t pid;
  std::string file;
  std::string copy;  ///< as seen from outside
  std::string host;
  bool trusted;
};

/// The first words of a command line; a process chooses how long its own is.
std::vector<std::string> words_of(const fs::path& command_line) {
  std::array<char, 16384> bytes;
  std::ifstream file(command_line, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  std::istringstream first(std::string(bytes.data(), static_cast<std::size_t>(file.gcount())));
  std::vector<std::string> words;
  for (std::string word; std::getline(first, word, '\0');) words.push_back(word);
  return words;
}

/// Whether a program stands where this one was installed: in its folder, or in `bin` of another
/// package of the same installation. One that was replaced since counts.
bool is_installed_beside(const fs::path& program, const fs::path& own) {
  const fs::path folder = program.parent_path();
  const bool both_in_bin = folder.filename() == "bin" && own.parent_path().filename() == "bin";
  return folder == own.parent_path() ||
         (both_in_bin &&
          folder.parent_path().parent_path() == own.parent_path().parent_path().parent_path());
}

/// Whether this user may trust that a process is a container: it is his own. Root also looks for
/// those of others, but only at containers of this installation, since anybody may call a process
/// so.
bool is_trusted(const fs::path& process, uid_t user) {
  struct stat owner {};
  if (::stat(process.c_str(), &owner) != 0) return false;
  if (owner.st_uid == user) return true;
  std::error_code gone;
  std::string program = fs::read_symlink(process / "exe", gone);
  const std::string replaced = " (deleted)";
  const std::size_t end = program.rfind(replaced);
  if (end != std::string::npos && end + replaced.size() == program.size()) program.resize(end);
  return user == 0 && !gone && fs::path(program).filename() == container_program &&
         is_installed_beside(program, fs::read_symlink("/proc/self/exe", gone));
}

/// What a process names, opened for reading. Nothing that is no regular file is opened: a FIFO
/// would wait for a writer, and a device may act.
FileDescriptor open_regular(const std::string& path) {
  const FileDescriptor seen(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (!seen || ::fstat(seen.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw EnvironmentError(path + ": is no file that can be read");
  }
  return FileDescriptor(::open(own_descriptor(seen).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
}

/// A path of a process as others reach it: its own descriptors, and what lies in its folder.
std::string from_outside(const fs::path& process, const std::string& path) {
  const std::string own = "/proc/self/";
  if (path.rfind(own, 0) == 0) return process / path.substr(own.size());
  return fs::path(path).is_absolute() ? path : (process / "cwd" / path).string();
}

std::optional<ContainerProcess> container_of(const fs::path& process, uid_t user) {
  const auto words = words_of(process / "cmdline");
  const bool is_one = words.size() >= 4 && fs::path(words[0]).filename() == container_program;
  if (!is_one) return std::nullopt;
  return ContainerProcess{std::stoi(process.filename()), words[1],
                          from_outside(process, words.size() > 4 ? words[4] : words[1]), words[2],
                          is_trusted(process, user)};
}

std::vector<ContainerProcess> containers(const std::string& proc, uid_t user) {
  std::vector<ContainerProcess> all;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(proc, failed)) {
    const std::string name = entry.path().filename();
    const bool is_process =
        name.size() < 10 &&
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_process) continue;
    if (auto found = container_of(entry.path(), user)) all.push_back(std::move(*found));
  }
  std::sort(all.begin(), all.end(),
            [](const ContainerProcess& a, const ContainerProcess& b) { return a.pid < b.pid; });
  return all;
}

bool is_known(const RunningHosts& found, const Deployment& deployment, const std::string& host) {
  return std::any_of(found.hosts.begin(), found.hosts.end(), [&](const RunningHost& one) {
    return one.host == host && one.deployment.run_dir == deployment.run_dir;
  });
}

}  // namespace

bool RunningHost::is_of(const std::string& run_dir) const {
  std::error_code gone;
  const fs::path wanted = fs::absolute(run_dir, gone).lexically_normal();
  return deployment.run_dir == wanted || fs::equivalent(deployment.run_dir, wanted, gone);
}

RunningHosts running_hosts(const std::string& proc, std::optional<uid_t> user) {
  RunningHosts found;
  for (const ContainerProcess& container : containers(proc, user.value_or(::geteuid()))) {
    try {
      if (!container.trusted) throw EnvironmentError("a process of another user");
      const FileDescriptor copy = open_regular(container.copy);
      Deployment deployment = load_resolved(container.file, own_descriptor(copy));
      const bool has_it = find_host(deployment, container.host) != nullptr;
      if (!has_it || is_known(found, deployment, container.host)) continue;
      found.hosts.push_back({std::move(deployment), container.host, container.pid});
    } catch (const std::exception&) {
      found.hidden.push_back(container.pid);
    }
  }
  return found;
}

RunningHost running_host(const std::string& run_dir, const std::string& host,
                         const std::string& proc) {
  RunningHosts running = running_hosts(proc);
  std::string what;
  for (RunningHost& one : running.hosts) {
    if (!one.is_of(run_dir)) continue;
    const std::string name =
        host.empty() ? one.deployment.hosts.front().name : host_named(one.deployment, host).name;
    if (one.host == name) return std::move(one);
    what = "host " + name + " of ";
  }
  throw EnvironmentError("nothing runs on " + what + run_dir +
                         (running.hidden.empty() ? "" : " that this user may look into"));
}

}  // namespace tocsin::deployment
