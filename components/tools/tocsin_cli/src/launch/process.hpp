// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "command_line/launch_plan.hpp"
#include "foundation/child_process.hpp"
#include "journal.hpp"
#include "line_splitter.hpp"
#include "restart_rule.hpp"

namespace tocsin::cli {

/// One process of the deployment over all of its restarts.
class Process {
 public:
  Process(ProcessSpec spec, const deployment::RestartPolicy& policy, Journal& journal);

  /// Starts it in the network namespace `network` (none: the launcher's) with `inherited` open.
  void start(std::optional<int> network, const std::vector<int>& inherited, Time now);
  /// Passes on what it has written.
  void read_output();
  /// How it ended, once, when it has; sweeps away what is left of its process group.
  [[nodiscard]] std::optional<Ending> reap();
  /// Asks the restart rule; a restart is due at start_at().
  [[nodiscard]] RestartDecision judge(const Ending& ending, Time now);
  /// Sends a signal to its process group, if it runs.
  void signal(int number) const;

  [[nodiscard]] const ProcessSpec& spec() const { return spec_; }
  [[nodiscard]] bool running() const { return child_.pid > 0; }
  [[nodiscard]] pid_t pid() const { return child_.pid; }
  [[nodiscard]] int output() const { return child_.output.get(); }
  /// When it is to be started again; never when it is not.
  [[nodiscard]] Time start_at() const { return start_at_; }
  /// The last line that it has written.
  [[nodiscard]] const std::string& last_line() const { return last_line_; }

 private:
  void pass_on(const std::string& line);

  ProcessSpec spec_;
  RestartRule rule_;
  Journal& journal_;
  Child child_;
  LineSplitter splitter_;
  std::string last_line_;
  Time start_at_ = never;
};

/// "exit code 3" or "signal 9 (Killed)".
[[nodiscard]] std::string describe(const Ending& ending);

}  // namespace tocsin::cli
