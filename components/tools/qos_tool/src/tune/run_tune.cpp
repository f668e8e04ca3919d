// SPDX-License-Identifier: Apache-2.0
#include "tune/run_tune.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <variant>
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

/// One round: which runs, of what, kept where.
struct Round {
  RunKind kind;
  std::vector<Candidate> candidates;
  fs::path folder;
  std::vector<std::string> options;  ///< of tocsin experiment run
};

/// Plays a round and tells its ranking, which is empty when no run ended well; else its exit code.
std::variant<int, std::vector<RankedCandidate>> play_and_rank(const TunePlan& plan, Round round) {
  const bool real = round.kind == RunKind::real;
  const fs::path results = round.folder / (real ? "real" : "simulated");
  const std::string file = write_experiment(plan, round.candidates, round.kind, round.folder);
  round.options.insert(round.options.begin(), {file, "--out", results});
  if (const int code = play(round.options); code != 0) return code;
  const CsvTable runs = CsvTable::load((results / (real ? "real.csv" : "runs.csv")).string());
  auto ranked = rank(runs, round.candidates);
  write(round.folder / (real ? "ranking_real.csv" : "ranking.csv"), ranking_csv(ranked));
  std::printf("\n%s, by what users feel (cost of tocsin experiment):\n%s",
              real ? "On the real stack" : "Simulated", ranking_text(ranked).c_str());
  std::fflush(stdout);  // before runs on the real stack, which take minutes
  if (ranked.empty()) return 1;
  return ranked;
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
  Round simulated{RunKind::simulated, candidates_of(plan), folder, {}};
  if (options.jobs) simulated.options = {"--jobs", std::to_string(*options.jobs)};
  const auto outcome = play_and_rank(plan, std::move(simulated));
  if (const int* const code = std::get_if<int>(&outcome)) return *code;
  if (plan.params.real_seeds == 0) return 0;
  const auto& ranked = std::get<std::vector<RankedCandidate>>(outcome);
  const auto in_reality = play_and_rank(plan, {RunKind::real,
                                               best_of(ranked, plan.params.best),
                                               folder,
                                               {"--real", "--jobs", std::to_string(real_jobs)}});
  const int* const code = std::get_if<int>(&in_reality);
  return code != nullptr ? *code : 0;
}

}  // namespace tocsin::qos_tool
