// SPDX-License-Identifier: Apache-2.0
#include "stack.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "command_line/programs.hpp"
#include "foundation/csv_table.hpp"
#include "foundation/datagram_socket.hpp"
#include "recorded.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

/// What a program of the installation would say of itself: it is either one folder for all packages
/// or has a folder for each.
fs::path installed_program() { return TOCSIN_INSTALL "/bin/program"; }

pid_t start(const std::vector<std::string>& words, const std::string& output) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t pid = fork();
  if (pid != 0) return pid;
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  execv(pointers[0], pointers.data());
  _exit(127);
}

/// What mounts a disk on a folder and becomes the command that follows.
std::vector<std::string> on_own_disk(const std::string& folder, int mib) {
  fs::create_directory(folder);
  const std::string options = "size=" + std::to_string(mib) + "m";
  return {"/usr/bin/unshare",
          getuid() == 0 ? "-m" : "-rm",
          "/bin/sh",
          "-c",
          "mount -t tmpfs -o " + options + " none " + folder + " && exec \"$@\"",
          "sh"};
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A process that is about to be: forked, but not in its host's network yet.
bool is_still_launcher(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/comm");
  std::string name;
  return std::getline(file, name) && name == "tocsin-launch";
}

}  // namespace

Ended run_to_end(const std::string& program, const std::string& arguments) {
  Ended ended;
  FILE* const pipe = ::popen((program + " " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return ended;
  std::array<char, 4096> block{};
  for (std::size_t size = 0; (size = std::fread(block.data(), 1, block.size(), pipe)) > 0;) {
    ended.output.append(block.data(), size);
  }
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  return ended;
}

Stack::Stack(const std::vector<std::string>& arguments, int disk_mib) : own_disk_(disk_mib > 0) {
  std::string name = "/tmp/tocsin_stack_XXXXXX";
  top_ = mkdtemp(name.data());
  folder_ = top_ + "/run";
  std::vector<std::string> words;
  if (own_disk_) words = on_own_disk(folder_, disk_mib);
  words.insert(words.end(), {program("tocsin"), "launch"});
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--run-dir", folder_});
  launcher_ = start(words, top_ + "/launch.out");
}

Stack::~Stack() {
  if (launcher_ > 0) {
    kill(launcher_, SIGTERM);
    if (exit_code(std::chrono::seconds(20)) == -1) kill(launcher_, SIGKILL);
  }
  if (!keep_) fs::remove_all(top_);
}

std::string Stack::setup() {
  const fs::path own = TOCSIN_INSTALL;
  for (const fs::path& folder : {own, own.parent_path()}) {
    if (fs::exists(folder / "setup.bash")) return folder / "setup.bash";
  }
  throw std::runtime_error("no setup.bash at " + own.string());
}

std::string Stack::program(const std::string& name) {
  const auto found = find_program(name, program_folders(installed_program(), ""));
  if (!found) throw std::runtime_error(name + " is not installed: build all packages first");
  return *found;
}

std::string Stack::share(const std::string& name) {
  return share_folder(installed_program()) / name;
}

bool Stack::eventually(std::chrono::seconds limit, const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

std::string Stack::path(const std::string& name) const {
  const std::string root = own_disk_ ? "/proc/" + std::to_string(launcher_) + "/root" : "";
  return root + folder_ + "/" + name;
}

std::string Stack::read(const std::string& name) const { return text_of(path(name)); }

std::string Stack::recorded(const std::string& side, const std::string& topic) const {
  return recorded_fields(path(side), topic);
}

std::string Stack::output() const { return text_of(top_ + "/launch.out"); }

bool Stack::logged(const std::string& text) const {
  return output().find(text) != std::string::npos;
}

std::vector<std::string> Stack::processes() const {
  const auto all = nlohmann::json::parse(read("processes.json"), nullptr, false);
  std::vector<std::string> names;
  if (!all.is_object()) return names;
  for (const auto& entry : all.items()) names.push_back(entry.key());
  return names;
}

pid_t Stack::pid(const std::string& process) const {
  const auto all = nlohmann::json::parse(read("processes.json"), nullptr, false);
  const pid_t pid = all.is_object() ? all.value(process, 0) : 0;
  return is_still_launcher(pid) ? 0 : pid;
}

pid_t Stack::running(const std::string& process) const {
  if (!eventually(std::chrono::seconds(30), [&] { return pid(process) != 0; })) {
    throw std::runtime_error(process + " does not run\n" + output());
  }
  return pid(process);
}

void Stack::fill_disk(const std::string& name) const {
  std::ofstream file(path(name), std::ios::binary);
  const std::string block(1U << 16U, 'x');
  while (file << block << std::flush) {
  }
}

bool Stack::remove_folder() const {
  return eventually(std::chrono::seconds(5), [&] {
    std::error_code busy;
    fs::remove_all(folder_, busy);
    return !busy;
  });
}

void Stack::control(const std::string& socket_name, const std::string& line) const {
  const auto error = DatagramSocket().send(path(socket_name), line);
  if (error) throw std::runtime_error(path(socket_name) + ": " + error.message());
}

int Stack::exit_code(std::chrono::seconds limit) {
  (void)eventually(limit, [this] {
    int status = 0;
    if (launcher_ > 0 && waitpid(launcher_, &status, WNOHANG) == launcher_) {
      code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      launcher_ = -1;
    }
    return launcher_ <= 0;
  });
  return code_;
}

bool is_driving(const Stack& stack) {
  const auto states = column(stack.recorded("uxv", "navigation_status"), "state");
  return std::find(states.begin(), states.end(), "driving") != states.end();
}

bool moves_in(const std::string& locations) {
  const auto x = column(locations, "pose.pose.position.x");
  const auto y = column(locations, "pose.pose.position.y");
  if (x.size() < 2 || y.size() != x.size()) return false;
  const auto step = [](const std::vector<std::string>& values) {
    return std::stod(values.back()) - std::stod(values[values.size() - 2]);
  };
  return std::hypot(step(x), step(y)) > 0.02;
}

std::vector<std::string> column(const std::string& csv, const std::string& name) {
  const CsvTable table(csv);
  std::vector<std::string> cells;
  if (!table.has(name)) return cells;
  for (std::size_t row = 0; row < table.rows(); ++row) cells.push_back(table.text(row, name));
  return cells;
}

}  // namespace tocsin
