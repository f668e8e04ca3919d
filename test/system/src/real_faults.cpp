// SPDX-License-Identifier: Apache-2.0
#include "real_faults.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace tocsin {
namespace {

/// Computes until it is killed.
class Hog {
 public:
  Hog() : pid_(::fork()) {
    if (pid_ != 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (volatile unsigned turns = 0;; turns = turns + 1) {
    }
  }
  ~Hog() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Hog(const Hog&) = delete;
  Hog& operator=(const Hog&) = delete;

 private:
  const pid_t pid_;
};

void freeze(pid_t process, std::chrono::seconds time) {
  ::kill(process, SIGSTOP);
  std::this_thread::sleep_for(time);
  ::kill(process, SIGCONT);
}

/// The emulator stands for the driver, which is loaded anew: it makes the interface again.
std::optional<std::string> delete_wlan0(const Stack& stack, std::chrono::seconds time) {
  const std::string inside = std::to_string(stack.pid("uxv/link"));
  const std::string command = "nsenter --net=/proc/" + inside + "/ns/net ip link delete wlan0";
  if (std::system((command + " 2>/dev/null").c_str()) != 0) return command + ": not done";
  std::this_thread::sleep_for(time);
  if (const pid_t radio = stack.pid("radio"); radio > 0) ::kill(radio, SIGKILL);
  return std::nullopt;
}

/// Takes all room of the run folder's disk for a while.
std::optional<std::string> fill_disk(const Stack& stack, std::chrono::seconds time) {
  const std::string path = stack.path("filling");
  stack.fill_disk("filling");
  std::this_thread::sleep_for(time);
  std::error_code error;
  if (std::filesystem::remove(path, error)) return std::nullopt;
  return path + ": cannot be removed: " + error.message();
}

}  // namespace

std::string to_text(const PlannedFault& planned) {
  std::string text = words_of(planned.fault)[static_cast<std::size_t>(planned.fault)];
  if (!planned.target.empty()) text += " " + planned.target;
  if (planned.time.count() > 0) text += fmt::format(" {} s", planned.time.count());
  return text;
}

PlannedFault draw_fault(std::mt19937& random, const std::vector<std::string>& processes) {
  constexpr unsigned longest_s = 12;  // longer than any lease on a host
  PlannedFault planned;
  planned.fault = static_cast<RealFault>(random() % words_of(RealFault::kill).size());
  const std::chrono::seconds time(1 + random() % longest_s);
  const std::string target = processes.empty() ? "" : processes[random() % processes.size()];
  const bool has_target = planned.fault == RealFault::kill || planned.fault == RealFault::freeze;
  if (has_target) planned.target = target;
  if (planned.fault != RealFault::kill) planned.time = time;
  return planned;
}

std::optional<std::string> inflict(const Stack& stack, const PlannedFault& planned) {
  const pid_t process = planned.target.empty() ? 0 : stack.pid(planned.target);
  switch (planned.fault) {
    case RealFault::kill:
      if (process > 0) ::kill(process, SIGKILL);
      return std::nullopt;
    case RealFault::freeze:
      if (process > 0) freeze(process, planned.time);
      return std::nullopt;
    case RealFault::wlan0:
      return delete_wlan0(stack, planned.time);
    case RealFault::full_disk:
      return fill_disk(stack, planned.time);
    case RealFault::cpu_hogs: {
      const std::vector<Hog> hogs(std::size_t{2} * std::thread::hardware_concurrency());
      std::this_thread::sleep_for(planned.time);
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace tocsin
