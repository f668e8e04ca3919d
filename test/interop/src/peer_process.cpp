// SPDX-License-Identifier: Apache-2.0
#include "peer_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "deployment/running_host.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  std::array<int, 2> ends{};
};

void enter_network_of(pid_t process) {
  try {
    deployment::enter_namespaces(process);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "interop_peer: %s\n", error.what());
    _exit(126);
  }
}

long long ms(std::chrono::steady_clock::time_point time) {
  return time.time_since_epoch() / std::chrono::milliseconds(1);
}

void end(pid_t process) {
  if (process <= 0) return;
  ::kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
}

}  // namespace

PeerProcess::PeerProcess(PeerOptions options) : name_(std::move(options.name)) {
  const Pipe in;
  const Pipe out;
  const std::string number = std::to_string(options.domain);
  const std::string loss = std::to_string(options.loss_percent);
  const std::string lifespan = std::to_string(options.lifespan_ms);
  pid_ = fork();
  if (pid_ == 0) {
    if (options.network != 0) enter_network_of(options.network);
    setenv("INTEROP_LOSS", loss.c_str(), 1);
    setenv("INTEROP_LIFESPAN_MS", lifespan.c_str(), 1);
    dup2(in.ends[0], STDIN_FILENO);
    dup2(out.ends[1], STDOUT_FILENO);
    execl(INTEROP_PEER, INTEROP_PEER, options.maker.c_str(), number.c_str(), name_.c_str(),
          nullptr);
    _exit(127);
  }
  close(in.ends[0]);
  close(out.ends[1]);
  input_ = in.ends[1];
  output_ = out.ends[0];
  thread_ = std::thread([this] { read_output(); });
}

PeerProcess::~PeerProcess() {
  kill();
  thread_.join();
  if (input_ >= 0) close(input_);
  close(output_);
}

void PeerProcess::freeze() const { ::kill(pid_, SIGSTOP); }
void PeerProcess::thaw() const { ::kill(pid_, SIGCONT); }
void PeerProcess::kill() { end(std::exchange(pid_, 0)); }
void PeerProcess::leave() { close(std::exchange(input_, -1)); }

void PeerProcess::read_output() {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t size = read(output_, buffer.data(), buffer.size());
    if (size <= 0) return;
    text.append(buffer.data(), static_cast<std::size_t>(size));
    const std::size_t whole = text.rfind('\n');
    if (whole == std::string::npos) continue;
    std::istringstream lines(text.substr(0, whole));
    text.erase(0, whole + 1);
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string name;
    long long written_ms = 0;
    long long number = 0;
    long long heard_ms = 0;
    while (lines >> name >> written_ms >> number >> heard_ms) {
      Heard& heard = heard_[name];
      heard.given.push_back({heard_ms, heard_ms - written_ms});
      heard.newest_ms = std::max(heard.newest_ms, written_ms);
      heard.in_a_row = number == heard.last + 1 ? heard.in_a_row + 1 : 1;
      heard.last = number;
    }
  }
}

bool PeerProcess::has_heard(const PeerProcess& other,
                            std::chrono::steady_clock::time_point since) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = heard_.find(other.name());
  return found != heard_.end() && found->second.newest_ms > ms(since);
}

std::chrono::milliseconds PeerProcess::oldest(const PeerProcess& other,
                                              std::chrono::steady_clock::time_point since) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  long long oldest_ms = 0;
  const auto found = heard_.find(other.name());
  if (found == heard_.end()) return {};
  for (const Given& one : found->second.given) {
    if (one.at_ms > ms(since)) oldest_ms = std::max(oldest_ms, one.age_ms);
  }
  return std::chrono::milliseconds(oldest_ms);
}

std::size_t PeerProcess::heard_in_a_row(const PeerProcess& other) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = heard_.find(other.name());
  return found == heard_.end() ? 0 : found->second.in_a_row;
}

bool shell(const std::string& command) { return std::system(command.c_str()) == 0; }

OtherComputer::OtherComputer() {
  const Pipe ready;
  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (unshare(CLONE_NEWNET) != 0) _exit(1);
    (void)!write(ready.ends[1], "", 1);
    for (;;) pause();
  }
  close(ready.ends[1]);
  char byte = 0;
  const bool unshared = read(ready.ends[0], &byte, 1) == 1;
  close(ready.ends[0]);
  const std::string pid = std::to_string(pid_);
  is_there_ =
      unshared &&
      shell("ip link add eth0 type veth peer name eth1 netns " + pid +
            " && ip address add 10.9.0.1/24 dev eth0 && ip link set eth0 up && nsenter -t " + pid +
            " -n sh -c 'ip link set lo up && ip address add 10.9.0.2/24 dev eth1 && ip link "
            "set eth1 up'");
  // Fast DDS ignores an interface that has no carrier yet; each end hears of it by itself.
  is_there_ = is_there_ && within(std::chrono::seconds(5), [&] {
                return shell("ip link show eth0 | grep -q 'state UP' && nsenter -t " + pid +
                             " -n ip link show eth1 | grep -q 'state UP'");
              });
}

OtherComputer::~OtherComputer() {
  (void)shell("ip link delete eth0 2>/dev/null");
  end(pid_);
}

}  // namespace tocsin::interop
