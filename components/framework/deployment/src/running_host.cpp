// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::deployment {
namespace {

namespace fs = std::filesystem;

/// A process that runs tocsin-container FILE HOST CONTAINER [COPY].
struct ContainerProcess {
  pid_t pid;
  std::string file;
  std::string copy;  ///< as seen from outside
  std::string host;
};

std::vector<std::string> words_of(const fs::path& command_line) {
  std::ifstream file(command_line, std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

/// A path of a process as others reach it: its own descriptors, and what lies in its folder.
std::string from_outside(const fs::path& process, const std::string& path) {
  const std::string own = "/proc/self/";
  if (path.rfind(own, 0) == 0) return process / path.substr(own.size());
  return fs::path(path).is_absolute() ? path : (process / "cwd" / path).string();
}

std::optional<ContainerProcess> container_of(const fs::path& process) {
  const auto words = words_of(process / "cmdline");
  const bool is_one = words.size() >= 4 && fs::path(words[0]).filename() == "tocsin-container";
  if (!is_one) return std::nullopt;
  return ContainerProcess{std::stoi(process.filename()), words[1],
                          from_outside(process, words.size() > 4 ? words[4] : words[1]), words[2]};
}

std::vector<ContainerProcess> containers(const std::string& proc) {
  std::vector<ContainerProcess> all;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(proc, failed)) {
    const std::string name = entry.path().filename();
    const bool is_process =
        name.size() < 10 &&
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_process) continue;
    if (auto found = container_of(entry.path())) all.push_back(std::move(*found));
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

RunningHosts running_hosts(const std::string& proc) {
  RunningHosts found;
  for (const ContainerProcess& container : containers(proc)) {
    try {
      Deployment deployment = load_resolved(container.file, container.copy);
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
