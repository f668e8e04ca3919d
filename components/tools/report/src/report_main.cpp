// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "foundation/error.hpp"
#include "report/plot.hpp"
#include "report/print.hpp"
#include "report/recording.hpp"
#include "report/summary.hpp"

namespace tocsin::report {
namespace {

struct Options {
  std::vector<std::string> runs;
  bool compare = false;
  bool no_plot = false;
};

int report(const std::string& folder, bool plot) {
  const Recording recording = load_recording(folder);
  const std::string text = to_text(summarise(recording));
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
  std::ofstream(folder + "/summary.txt") << text;
  if (plot) {
    draw_plot(recording);
    std::printf("\nPlot      %s/plot.png, plot.svg\n", folder.c_str());
  }
  return 0;
}

int compare(const std::vector<std::string>& folders) {
  if (folders.size() != 2) throw ConfigError("--compare needs two run folders");
  const Summary first = summarise(load_recording(folders[0]));
  const Summary second = summarise(load_recording(folders[1]));
  std::fputs(compare_text(first, second).c_str(), stdout);
  return 0;
}

int run(const Options& options) {
  if (options.compare) return compare(options.runs);
  if (options.runs.size() != 1) throw ConfigError("one run folder, or --compare and two");
  return report(options.runs[0], !options.no_plot);
}

}  // namespace
}  // namespace tocsin::report

int main(int argc, char** argv) {
  CLI::App app{"Summarise and plot a recorded run, or compare two", "tocsin report"};
  tocsin::report::Options options;
  app.add_option("RUN", options.runs, "folder of a run; two with --compare")->required();
  app.add_flag("--compare", options.compare, "one table of two runs");
  app.add_flag("--no-plot", options.no_plot, "only the summary");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::report::run(options); });
}
