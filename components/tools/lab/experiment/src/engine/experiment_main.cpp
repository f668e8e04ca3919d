// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

#include "command_line/command.hpp"
#include "command_line/programs.hpp"
#include "engine/run_experiment.hpp"
#include "engine/trace_export.hpp"
#include "foundation/error.hpp"
#include "report/recording.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

/// Options that `run` and `fit` have in common.
void add_common(CLI::App& run, RunOptions& options) {
  run.add_option("FILE", options.file,
                 "experiment file; a bare name is also looked for in the share")
      ->required();
  run.add_option("--jobs", options.jobs, "runs at a time [simulated: all cores; real: 4]")
      ->check(CLI::Range(1, 256));
  run.add_option("--out", options.out, "folder of the results [experiments/<FILE>]");
  run.add_flag("--other-build", options.other_build,
               "go on in a folder that another build of the programs has begun");
}

CLI::App& add_run(CLI::App& app, RunOptions& options) {
  CLI::App& run = *app.add_subcommand("run", "Run an experiment file, or go on with it");
  add_common(run, options);
  run.add_flag_callback(
      "--real", [&options] { options.task = Task::real; },
      "the runs of kind real, on the real stack in real time");
  return run;
}

CLI::App& add_fit(CLI::App& app, RunOptions& options) {
  CLI::App& fit = *app.add_subcommand(
      "fit", "Fit the parameters of all policies to the runs of kind fit, by one rule");
  add_common(fit, options);
  return fit;
}

int run(RunOptions options, bool jobs_given) {
  options.share = share_folder(own_program());
  const fs::path shared = fs::path(options.share) / "config/experiments" / options.file;
  if (!fs::exists(options.file) && fs::exists(shared)) options.file = shared;
  if (options.out.empty()) {
    options.out = "experiments/" + fs::path(options.file).stem().string();
    if (options.task == Task::fit) options.out += ".fit";
  }
  options.out = fs::absolute(options.out).lexically_normal();
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  if (!jobs_given) options.jobs = options.task == Task::real ? 4 : static_cast<int>(cores);
  return options.task == Task::fit ? fit_experiment(options) : run_experiment(options);
}

/// The page is made by report/, with Debian's Python, for which bringup/packages.txt has the
/// libraries; another one may come first in $PATH.
int write_report(const std::string& folder) {
  constexpr const char* python = "/usr/bin/python3";
  const fs::path report = own_program().parent_path().parent_path() / "share/experiment/report";
  execl(python, python, "-B", report.c_str(), folder.c_str(), nullptr);
  throw EnvironmentError(std::string(python) + ": " + std::strerror(errno) +
                         " (packages python3-jinja2, python3-matplotlib and python3-yaml)");
}

int print_trace(const std::string& folder) {
  std::fputs(trace_text(report::load_recording(folder)).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace tocsin::experiment

int main(int argc, char** argv) {
  using namespace tocsin::experiment;
  CLI::App app{"Compare policies over many runs: in simulated time, or on the real stack",
               "tocsin experiment"};
  app.require_subcommand(1);
  RunOptions options;
  CLI::App& run_command = add_run(app, options);
  CLI::App& fit_command = add_fit(app, options);
  std::string folder;
  CLI::App& report = *app.add_subcommand("report", "Write report.html and figures of the results");
  report.add_option("DIR", folder, "folder of the results")->required();
  CLI::App& trace =
      *app.add_subcommand("trace", "Print a recorded run's link as a trace to replay");
  trace.add_option("RUN", folder, "folder of a recorded run")->required();
  return tocsin::run_command(app, argc, argv, [&] {
    if (report.parsed()) return write_report(folder);
    if (trace.parsed()) return print_trace(folder);
    if (fit_command.parsed()) options.task = Task::fit;
    return run(options, run_command.count("--jobs") + fit_command.count("--jobs") > 0);
  });
}
