// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "disk_watch.hpp"
#include "journal.hpp"
#include "network.hpp"
#include "process.hpp"
#include "served_port.hpp"
#include "service_manager.hpp"
#include "signals.hpp"

namespace tocsin::cli {

/// Starts the processes of a deployment, keeps them running, and stops them in reverse order.
class Launcher {
 public:
  /// `radio` is the emulator's process, at most one; `networks` one for each host with it, else
  /// none. All references must outlive the launcher.
  Launcher(const deployment::Deployment& deployment, const std::vector<HostNetwork>& networks,
           Signals& signals, Journal& journal, ServiceManager& service);
  /// Tells of each port, on the terminal, and hands its socket to its process.
  void serve(std::vector<ServedPort> ports);
  /// Adds a process; they start in this order, the first alone until the radio link is there.
  void add(ProcessSpec spec);
  /// Runs until everything has ended; the exit code of the program.
  [[nodiscard]] int run();

 private:
  enum class Phase { link, running, stopping };

  void start(Process& process, Time now);
  void start_all(Time now);
  void write_processes();
  void look_at_disk(Time now);
  void wait(Time until);
  [[nodiscard]] Time next_deadline(Time now) const;
  void take_signals();
  void on_stop_signal(int number);
  void reap_all(Time now);
  void on_exit(Process& process, const Ending& ending, Time now);
  [[nodiscard]] bool ends_the_run(const std::string& process) const;
  void on_end_of_run(const std::string& process, int code, const std::string& end,
                     const std::string& said);
  void advance(Time now);
  void wait_for_link(Time now);
  void continue_stop(Time now);
  void stop(int exit_code, const std::string& why);
  [[nodiscard]] bool is_done() const;
  [[nodiscard]] bool has_link() const;

  const deployment::Deployment& deployment_;
  const std::vector<HostNetwork>& networks_;
  Signals& signals_;
  Journal& journal_;
  ServiceManager& service_;
  std::list<Process> processes_;
  std::vector<ServedPort> ports_;
  Phase phase_ = Phase::running;
  Time link_deadline_ = never;
  Process* ending_ = nullptr;  ///< the process that has been told to stop
  Time kill_at_ = never;
  int exit_code_ = 0;
  std::set<std::string> ended_;  ///< of stop_when_exits
  int code_of_run_ = 0;          ///< the highest of theirs
  DiskWatch disk_;
  Time next_look_{};
  bool had_no_room_ = false;  ///< for the list of processes
};

}  // namespace tocsin::cli
