// SPDX-License-Identifier: Apache-2.0
#include "launcher.hpp"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>

#include "foundation/free_space.hpp"
#include "foundation/replace_file.hpp"
#include "run_folder.hpp"

namespace tocsin::cli {
namespace {

using std::chrono::milliseconds;

constexpr Duration link_within = std::chrono::seconds(10);
constexpr Duration link_poll = milliseconds(20);
constexpr Duration disk_period = std::chrono::seconds(1);
constexpr Duration stop_within = std::chrono::seconds(3);

Time clock_now() { return std::chrono::steady_clock::now(); }

}  // namespace

Launcher::Launcher(const deployment::Deployment& deployment,
                   const std::vector<HostNetwork>& networks, Signals& signals, Journal& journal,
                   ServiceManager& service)
    : deployment_(deployment),
      networks_(networks),
      signals_(signals),
      journal_(journal),
      service_(service),
      disk_(deployment.run_dir) {}

void Launcher::add(ProcessSpec spec) {
  processes_.emplace_back(std::move(spec), deployment_.restart, journal_);
}

void Launcher::serve(std::vector<ServedPort> ports) {
  for (const ServedPort& one : ports) {
    if (one.socket) {
      journal_.say(one.process + " serves " + one.url);
    } else {
      journal_.say(one.process + " cannot serve " + one.url + ": " + one.fault +
                   "; all else goes on");
    }
  }
  ports_ = std::move(ports);
}

int Launcher::run() {
  const Time begin = clock_now();
  if (networks_.empty()) {
    start_all(begin);
  } else {
    phase_ = Phase::link;
    link_deadline_ = begin + link_within;
    start(processes_.front(), begin);
  }
  while (!is_done()) {
    wait(next_deadline(clock_now()));
    take_signals();
    for (Process& process : processes_) process.read_output();
    reap_all(clock_now());
    advance(clock_now());
    look_at_disk(clock_now());
    service_.alive(clock_now());
  }
  write_processes();
  sweep(deployment_.run_dir);
  return exit_code_;
}

void Launcher::start(Process& process, Time now) {
  const auto host = process.spec().host;
  std::vector<int> inherited;
  std::optional<int> network;
  if (!host) {
    for (const HostNetwork& each : networks_) inherited.push_back(each.descriptor());
  } else if (!networks_.empty()) {
    network = networks_[*host].descriptor();
  }
  for (const ServedPort& one : ports_) {
    if (one.process == process.spec().name && one.socket) inherited.push_back(one.socket.get());
  }
  process.start(network, inherited, now);
  write_processes();
}

void Launcher::start_all(Time now) {
  phase_ = Phase::running;
  for (Process& process : processes_) {
    if (!process.running()) start(process, now);
  }
  service_.ready(std::to_string(processes_.size()) + " processes, run folder " +
                 deployment_.run_dir);
}

void Launcher::write_processes() {
  std::map<std::string, int> pids;
  for (const Process& process : processes_) {
    if (process.running()) pids[process.spec().name] = process.pid();
  }
  had_no_room_ = is_disk_full(write_pids(deployment_.run_dir, pids));
}

void Launcher::look_at_disk(Time now) {
  if (now < next_look_) return;
  next_look_ = now + disk_period;
  if (had_no_room_) write_processes();  // a spent quota shows only so
  std::error_code ignored;
  std::optional<std::uint64_t> room;
  if (std::filesystem::exists(deployment_.run_dir, ignored)) {
    constexpr std::uint64_t enough = std::numeric_limits<std::uint64_t>::max();
    room = had_no_room_ ? 0 : free_bytes(deployment_.run_dir).value_or(enough);
  }
  if (const auto text = disk_.on_look(room)) journal_.say(*text);
}

void Launcher::wait(Time until) {
  std::vector<pollfd> watched{{signals_.descriptor(), POLLIN, 0}};
  for (const Process& process : processes_) {
    if (process.output() >= 0) watched.push_back({process.output(), POLLIN, 0});
  }
  int timeout_ms = -1;
  if (until != never) {
    const Duration left = std::max(until - clock_now(), Duration{});
    timeout_ms = static_cast<int>(std::chrono::ceil<milliseconds>(left).count());
  }
  ::poll(watched.data(), watched.size(), timeout_ms);
}

Time Launcher::next_deadline(Time now) const {
  if (phase_ == Phase::link) return now + link_poll;
  if (phase_ == Phase::stopping) return std::min(kill_at_, service_.next_sign());
  Time next = std::min(next_look_, service_.next_sign());
  for (const Process& process : processes_) next = std::min(next, process.start_at());
  return next;
}

void Launcher::take_signals() {
  for (int number = signals_.take(); number != 0; number = signals_.take()) {
    if (number != SIGCHLD) on_stop_signal(number);
  }
}

void Launcher::on_stop_signal(int number) {
  if (phase_ != Phase::stopping) {
    stop(128 + number, std::string("stopping: ") + (number == SIGINT ? "Ctrl-C" : "asked to stop"));
    return;
  }
  for (const Process& process : processes_) process.signal(SIGKILL);
}

void Launcher::reap_all(Time now) {
  bool changed = false;
  for (Process& process : processes_) {
    const auto ending = process.reap();
    if (!ending) continue;
    changed = true;
    on_exit(process, *ending, now);
  }
  if (changed) write_processes();
}

void Launcher::on_exit(Process& process, const Ending& ending, Time now) {
  if (phase_ == Phase::stopping) return;
  const std::string& name = process.spec().name;
  const std::string end = name + " ended with " + describe(ending);
  const std::string said = process.last_line().empty() ? "" : ": " + process.last_line();
  if (ends_the_run(name) && !ending.by_signal && ending.code <= 1) {
    return on_end_of_run(name, ending.code, end, ending.code == 0 ? "" : said);
  }
  const RestartDecision decision = process.judge(ending, now);
  switch (decision.kind) {
    case RestartDecision::Kind::finished:
      return;
    case RestartDecision::Kind::restart:
      journal_.say(end + ", restarting");
      return;
    case RestartDecision::Kind::refused:
      stop(decision.exit_code, end + ", stopping" + said);
      return;
    case RestartDecision::Kind::too_often:
      stop(decision.exit_code, end + " too often, stopping" + said);
  }
}

bool Launcher::ends_the_run(const std::string& process) const {
  const auto& all = deployment_.stop_when_exits;
  return std::find(all.begin(), all.end(), process) != all.end();
}

/// Of several it is the last one, and the highest code counts.
void Launcher::on_end_of_run(const std::string& process, int code, const std::string& end,
                             const std::string& said) {
  ended_.insert(process);
  code_of_run_ = std::max(code_of_run_, code);
  const std::size_t left = deployment_.stop_when_exits.size() - ended_.size();
  if (left == 0) return stop(code_of_run_, end + ", stopping" + said);
  journal_.say(end + said + "; " + std::to_string(left) + " to go");
}

void Launcher::advance(Time now) {
  if (phase_ == Phase::link) wait_for_link(now);
  if (phase_ == Phase::stopping) continue_stop(now);
  if (phase_ == Phase::stopping) return;
  for (Process& process : processes_) {
    if (process.start_at() <= now) start(process, now);
  }
}

void Launcher::wait_for_link(Time now) {
  if (has_link()) {
    start_all(now);
  } else if (now >= link_deadline_) {
    stop(1,
         "radio: wlan0 did not come up within 10 s, stopping: " + processes_.front().last_line());
  }
}

bool Launcher::has_link() const {
  for (std::size_t i = 0; i < networks_.size(); ++i) {
    if (!networks_[i].has_link(deployment_.hosts[i].address)) return false;
  }
  return true;
}

void Launcher::stop(int exit_code, const std::string& why) {
  phase_ = Phase::stopping;
  exit_code_ = exit_code;
  service_.stopping();
  journal_.say(why);
}

void Launcher::continue_stop(Time now) {
  if (ending_ != nullptr && ending_->running()) {
    if (now < kill_at_) return;
    journal_.say(ending_->spec().name + " did not stop within 3 s, killed");
    ending_->signal(SIGKILL);
    kill_at_ = never;
    return;
  }
  const auto last = std::find_if(processes_.rbegin(), processes_.rend(),
                                 [](const Process& process) { return process.running(); });
  ending_ = last == processes_.rend() ? nullptr : &*last;
  kill_at_ = ending_ == nullptr ? never : now + stop_within;
  if (ending_ != nullptr) ending_->signal(SIGTERM);
}

bool Launcher::is_done() const {
  return std::none_of(processes_.begin(), processes_.end(), [this](const Process& process) {
    return process.running() || (phase_ != Phase::stopping && process.start_at() != never);
  });
}

}  // namespace tocsin::cli
