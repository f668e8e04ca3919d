// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "page.hpp"
#include "report/recording.hpp"
#include "run_experiment.hpp"
#include "trace_export.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

/// bringup's share folder, installed in one folder with this program or in one per package.
fs::path share_folder() {
  const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
  const fs::path together = prefix / "share/tocsin";
  return fs::is_directory(together) ? together : prefix.parent_path() / "bringup/share/tocsin";
}

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
  options.share = share_folder();
  const fs::path shared = fs::path(options.share) / "config/experiments" / options.file;
  if (!fs::exists(options.file) && fs::exists(shared)) options.file = shared;
  if (options.out.empty()) options.out = "experiments/" + fs::path(options.file).stem().string();
  options.out = fs::absolute(options.out).lexically_normal();
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  if (!jobs_given) options.jobs = options.real ? 4 : static_cast<int>(cores);
  return run_experiment(options);
}

int body(int argc, char** argv) {
  CLI::App app{"Compare policies over many runs: in simulated time, or on the real stack"};
  app.name("tocsin experiment");
  app.require_subcommand(1);
  RunOptions options;
  CLI::App& run_command = add_run(app, options);
  std::string folder;
  CLI::App& report = *app.add_subcommand("report", "Write report.html and figures of the results");
  report.add_option("DIR", folder, "folder of the results")->required();
  CLI::App& trace =
      *app.add_subcommand("trace", "Print a recorded run's link as a trace to replay");
  trace.add_option("RUN", folder, "folder of a recorded run")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw ConfigError(error.what());
  }
  if (report.parsed()) return write_page(folder);
  if (trace.parsed()) {
    std::fputs(trace_text(report::load_recording(folder)).c_str(), stdout);
    return 0;
  }
  return run(options, run_command.count("--jobs") > 0);
}

}  // namespace
}  // namespace tocsin::experiment

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin experiment",
                             [&] { return tocsin::experiment::body(argc, argv); });
}
