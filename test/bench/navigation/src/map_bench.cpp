// SPDX-License-Identifier: Apache-2.0
// map_bench [--logs FOLDER]: accuracy of `tocsin map replay` on logs with verified relations,
// beside published figures; times of matching, of looking for loops and of solving; false loops.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "command_line/command.hpp"
#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"
#include "foundation/read_file.hpp"
#include "foundation/temporary_folder.hpp"
#include "map_timings.hpp"
#include "planted_loops.hpp"
#include "relations.hpp"

namespace tocsin::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = std::size_t{1} << 28U;  // [byte]

std::vector<fs::path> logs_of(const std::string& folder) {
  std::vector<fs::path> logs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".clf") logs.push_back(entry.path());
  }
  std::sort(logs.begin(), logs.end());
  return logs;
}

std::string cells_of(const RelationErrors& errors) {
  return fmt::format("{} | {:.4f} +- {:.4f} | {:.3f} | {:.2f}", errors.count, errors.mean_m,
                     errors.deviation_m, errors.worst_m, errors.mean_deg);
}

void print_log(const fs::path& log, const TemporaryFolder& folder) {
  const std::string trajectory = folder.path(log.stem().string());
  const Ended ended =
      run_to_end({"tocsin-map", "replay", log.string(), "--trajectory", trajectory});
  if (ended.code != 0) throw EnvironmentError(log.string() + ": " + ended.output);
  fmt::print("{}: {}", log.stem().string(), ended.output);
  const fs::path relations = fs::path(log).replace_extension(".relations");
  if (!fs::exists(relations)) return;
  const std::string poses = read_file(trajectory, longest_file);
  const std::string truth = read_file(relations.string(), longest_file);
  fmt::print("| {} | relations | m | worst, m | deg |\n| --- | --- | --- | --- | --- |\n",
             log.stem().string());
  fmt::print("| all | {} |\n", cells_of(relation_errors(poses, truth, false)));
  fmt::print("| more than 30 s apart | {} |\n", cells_of(relation_errors(poses, truth, true)));
}

void print_published() {
  fmt::print(
      "\n| published, m (deg) | Intel | MIT Killian | Freiburg 79 |\n| --- | --- | --- | --- |\n"
      "| scan matching | 0.220 +- 0.296 | 1.651 +- 4.138 | 0.258 +- 0.427 |\n"
      "| gmapping | 0.070 +- 0.083 | 0.122 +- 0.386 | 0.061 +- 0.044 |\n"
      "| graph mapping (Karto's kind) | 0.031 +- 0.026 (1.3) | 0.050 +- 0.056 (0.5) | 0.056 +- "
      "0.042 (0.6) |\n"
      "| Cartographer | 0.023 +- 0.024 (0.45) | 0.040 +- 0.049 (0.35) | 0.045 +- 0.035 (0.54) |\n"
      "Kuemmerle et al. 2009; Hess et al. 2016, of whole logs.\n\n");
}

void print_timing(const char* name, const Timing& timing, const char* target) {
  fmt::print("| {} | {:.2f} | {:.2f} | {} |\n", name, timing.mean_ms, timing.p99_ms, target);
  std::fflush(stdout);
}

int run(const std::string& folder) {
  const TemporaryFolder temporary;
  const auto logs = logs_of(folder);
  if (logs.empty()) fmt::print("no logs in {}: times only\n", folder);
  for (const fs::path& log : logs) print_log(log, temporary);
  print_published();
  fmt::print("| step | mean, ms | p99, ms | target |\n| --- | --- | --- | --- |\n");
  print_timing("match of 360 beams, 0.3 m, 15 deg", time_matches(), "2 mean, 5 p99");
  print_timing("look for a loop, 4 m, 45 deg", time_loop_searches(), "20");
  print_timing("solve of 1,000 nodes", time_solve(1000), "50");
  TownGraph clean = town_graph(1000, 0);
  TownGraph planted = town_graph(1000, 100);
  clean.graph.solve();
  planted.graph.solve();
  fmt::print("\n100 false loops: error {:.4f} m, without them {:.4f} m\n", error_m(planted),
             error_m(clean));
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  std::string folder = "../shared/data/slam";
  CLI::App app("Accuracy and cost of mapping; needs tocsin-map in the PATH.");
  app.name("map_bench");
  app.add_option("--logs", folder, "folder with NAME.clf and NAME.relations [../shared/data/slam]");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(folder); });
}
