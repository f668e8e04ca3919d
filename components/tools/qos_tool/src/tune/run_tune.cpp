// SPDX-License-Identifier: Apache-2.0
#include "tune/run_tune.hpp"

#include <algorithm>
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

/// Runs on the real stack side by side: each has some ten processes and wants little of a core.
constexpr int real_jobs = 3;

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
                             RunKind kind, const fs::path& folder) {
  for (const Candidate& candidate : candidates) {
    const std::string qos = qos_text(plan, candidate);
    const std::string traffic = traffic_text(plan, candidate);
    if (!qos.empty()) write(folder / (candidate.name + ".qos.yaml"), qos);
    if (!traffic.empty()) write(folder / (candidate.name + ".traffic.yaml"), traffic);
  }
  const fs::path file = folder / (kind == RunKind::real ? "real.yaml" : "simulated.yaml");
  write(file, experiment_text(plan, candidates, kind));
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

/// The shipped one and the best of the others.
std::vector<Candidate> best_of(const std::vector<RankedCandidate>& ranked, int wanted) {
  std::vector<Candidate> chosen{{"shipped", {}}};
  for (const RankedCandidate& one : ranked) {
    if (static_cast<int>(chosen.size()) > wanted) break;
    if (!one.candidate.settings.empty()) chosen.push_back(one.candidate);
  }
  return chosen;
}

int play_and_rank(const TunePlan& plan, const std::vector<Candidate>& candidates, RunKind kind,
                  const fs::path& folder, std::vector<std::string> more,
                  std::vector<RankedCandidate>& ranked) {
  const bool real = kind == RunKind::real;
  const fs::path results = folder / (real ? "real" : "simulated");
  more.insert(more.begin(), {write_experiment(plan, candidates, kind, folder), "--out", results});
  if (const int code = play(more); code != 0) return code;
  ranked = rank(CsvTable::load((results / (real ? "real.csv" : "runs.csv")).string()), candidates);
  write(folder / (real ? "ranking_real.csv" : "ranking.csv"), ranking_csv(ranked));
  std::printf("\n%s, by what users feel (cost of tocsin experiment):\n%s",
              real ? "On the real stack" : "Simulated", ranking_text(ranked).c_str());
  std::fflush(stdout);  // before runs on the real stack, which take minutes
  return ranked.empty() ? 1 : 0;
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
  std::vector<std::string> more;
  if (options.jobs) more = {"--jobs", std::to_string(*options.jobs)};
  std::vector<RankedCandidate> ranked;
  const int code =
      play_and_rank(plan, candidates_of(plan), RunKind::simulated, folder, more, ranked);
  if (code != 0 || plan.params.real_seeds == 0) return code;
  std::vector<RankedCandidate> in_reality;
  return play_and_rank(plan, best_of(ranked, plan.params.best), RunKind::real, folder,
                       {"--real", "--jobs", std::to_string(real_jobs)}, in_reality);
}

}  // namespace tocsin::qos_tool
