// SPDX-License-Identifier: Apache-2.0
#include "tune/run_tune.hpp"

#include <cstdio>
#include <filesystem>
#include <vector>

#include "command_line/programs.hpp"
#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "tune/ranking.hpp"
#include "tune/tune_plan.hpp"

namespace tocsin::qos_tool {
namespace {

namespace fs = std::filesystem;

std::string file_of(const std::string& given) {
  const fs::path shipped = share_folder(own_program()) / "config/experiments" / given;
  const bool bare = given.find('/') == std::string::npos;
  return bare && !fs::exists(given) && fs::exists(shipped) ? shipped.string() : given;
}

void write(const fs::path& path, const std::string& text) {
  const std::error_code error = replace_file(path.string(), text);
  if (error) throw EnvironmentError(path.string() + ": " + error.message());
}

/// Writes an experiment of these candidates, with their files, and gives its path.
std::string write_experiment(const TunePlan& plan, const std::vector<Candidate>& candidates,
                             const fs::path& folder) {
  for (const Candidate& candidate : candidates) {
    const std::string qos = qos_text(plan, candidate);
    const std::string traffic = traffic_text(plan, candidate);
    if (!qos.empty()) write(folder / (candidate.name + ".qos.yaml"), qos);
    if (!traffic.empty()) write(folder / (candidate.name + ".traffic.yaml"), traffic);
  }
  const fs::path file = folder / "simulated.yaml";
  write(file, experiment_text(plan, candidates));
  return file.string();
}

/// `tocsin experiment run` of the same installation.
int play(const std::vector<std::string>& arguments) {
  const auto program = find_program("tocsin-experiment", program_folders());
  if (!program) throw EnvironmentError("tocsin-experiment is not installed beside tocsin-qos");
  std::vector<std::string> command{*program, "run"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return wait_for_child(start_child({command}).pid);
}

}  // namespace

int run_tune(const TuneOptions& options) {
  const std::string file = file_of(options.file);
  const TunePlan plan = read_tune_plan(file, (share_folder(own_program()) / "config").string());
  const fs::path folder =
      options.out.empty() ? fs::path("tuning") / fs::path(file).stem() : fs::path(options.out);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw EnvironmentError(folder.string() + ": " + error.message());
  const auto candidates = candidates_of(plan);
  const fs::path results = folder / "simulated";
  std::vector<std::string> words{write_experiment(plan, candidates, folder), "--out", results};
  if (options.jobs) words.insert(words.end(), {"--jobs", std::to_string(*options.jobs)});
  if (const int code = play(words); code != 0) return code;
  const auto ranked = rank(CsvTable::load((results / "runs.csv").string()), candidates);
  std::printf("\nBy what users feel (cost of tocsin experiment):\n%s",
              ranking_text(ranked).c_str());
  return ranked.empty() ? 1 : 0;
}

}  // namespace tocsin::qos_tool
