// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "command_line/command.hpp"
#include "command_line/programs.hpp"
#include "page.hpp"
#include "report/recording.hpp"
#include "run_experiment.hpp"
#include "trace_export.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

CLI::App& add_run(CLI::App& app, RunOptions& options) {
  CLI::App& run = *app.add_subcommand("run", "Run an experiment file, or go on with it");
  run.add_option("FILE", options.file,
                 "experiment file; a bare name is also looked for in the share")
      ->required();
  run.add_option("--jobs", options.jobs, "runs at a time [simulated: all cores; real: 4]")
      ->check(CLI::Range(1, 256));
  run.add_option("--out", options.out, "folder of the results [experiments/<FILE>]");
  run.add_flag("--real", options.real, "the runs of kind real, on the real stack in real time");
  return run;
}

int run(RunOptions options, bool jobs_given) {
  options.share = share_folder(own_program());
  const fs::path shared = fs::path(options.share) / "config/experiments" / options.file;
  if (!fs::exists(options.file) && fs::exists(shared)) options.file = shared;
  if (options.out.empty()) options.out = "experiments/" + fs::path(options.file).stem().string();
  options.out = fs::absolute(options.out).lexically_normal();
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  if (!jobs_given) options.jobs = options.real ? 4 : static_cast<int>(cores);
  return run_experiment(options);
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
  std::string folder;
  CLI::App& report = *app.add_subcommand("report", "Write report.html and figures of the results");
  report.add_option("DIR", folder, "folder of the results")->required();
  CLI::App& trace =
      *app.add_subcommand("trace", "Print a recorded run's link as a trace to replay");
  trace.add_option("RUN", folder, "folder of a recorded run")->required();
  return tocsin::run_command(app, argc, argv, [&] {
    if (report.parsed()) return write_page(folder);
    if (trace.parsed()) return print_trace(folder);
    return run(options, run_command.count("--jobs") > 0);
  });
}
