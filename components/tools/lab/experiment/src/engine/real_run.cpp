// SPDX-License-Identifier: Apache-2.0
#include "engine/real_run.hpp"

#include <signal.h>
#include <sys/wait.h>

#include <exception>
#include <filesystem>

#include "command_line/programs.hpp"
#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "report/recording.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

std::string run_folder(const Run& run, const Places& places) {
  return places.folder + "/real/" + run.id() + ".run";
}

/// tocsin-launch of the same installation.
std::string launcher() {
  return find_program("tocsin-launch", program_folders()).value_or("tocsin-launch");
}

/// Waits for the child; a run that is not over after its time is ended as by a user.
int wait_for(pid_t child, double limit_s) {
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  bool told = false;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    const timespec pause{1, 0};
    (void)::sigtimedwait(&child_ended, nullptr, &pause);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    if (elapsed.count() > limit_s && !told) {
      told = true;
      ::kill(child, SIGTERM);
    }
  }
  return status;
}

/// Runs a command to its end.
int execute(const std::vector<std::string>& command, double limit_s) {
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &blocked, nullptr);
  return wait_for(start_child({command}).pid, limit_s);
}

RunResult measure_folder(const std::string& folder, const Timing& timing) {
  report::Recording recording = report::load_recording(folder);
  if (!recording.link.empty()) recording.begin_s = recording.link.front().time_s;
  return {"", recording.end_s - recording.begin_s, measure(recording, timing)};
}

}  // namespace

std::vector<std::string> launch_command(const Run& run, const Timing& timing,
                                        const Places& places) {
  const auto overrides = overrides_of(run, timing, places.share, run_folder(run, places));
  std::vector<std::string> command{launcher(),        timing.bringup,   "--run-dir",
                                   overrides.run_dir, "--seed",         std::to_string(run.seed),
                                   "--channel",       overrides.channel};
  for (const std::string& setting : overrides.set) {
    command.emplace_back("--set");
    command.push_back(setting);
  }
  if (!overrides.qos.empty()) command.insert(command.end(), {"--qos", overrides.qos});
  if (!overrides.traffic.empty()) command.insert(command.end(), {"--traffic", overrides.traffic});
  for (const std::string& process : overrides.without) {
    command.emplace_back("--without");
    command.push_back(process);
  }
  return command;
}

RunResult drive(const Run& run, const Timing& timing, const Places& places) {
  int status = 0;
  try {
    const std::string folder = run_folder(run, places);
    fs::remove_all(folder);
    status = execute(launch_command(run, timing, places), timing.duration_s);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
      return {launcher() + ": cannot be started", 0, {}};
    }
    return measure_folder(folder, timing);
  } catch (const std::exception& error) {
    const bool refused = WIFEXITED(status) && WEXITSTATUS(status) != 0;
    const std::string code = "tocsin-launch ended with " + std::to_string(WEXITSTATUS(status));
    return {(refused ? code + "; " : "") + error.what(), 0, {}};
  }
}

}  // namespace tocsin::experiment
