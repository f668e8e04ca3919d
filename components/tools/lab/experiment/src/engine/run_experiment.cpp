// SPDX-License-Identifier: Apache-2.0
#include "engine/run_experiment.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include "engine/pool.hpp"
#include "engine/progress.hpp"
#include "engine/real_run.hpp"
#include "engine/settings.hpp"
#include "foundation/error.hpp"
#include "foundation/folder_lock.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {
namespace {

/// Exit codes of a job from here on are errno of a disk that did not take the result.
constexpr int disk_error = 64;

/// Folder of the results of a task.
std::string kind_of(Task task) {
  if (task == Task::real) return "real";
  return task == Task::fit ? "fit" : "series";
}

bool belongs_to(Task task, SetKind kind) {
  if (task == Task::real) return kind == SetKind::real;
  return (task == Task::fit) == (kind == SetKind::fit);
}

const std::string& made(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw EnvironmentError(folder + ": cannot be made: " + error.message());
  return folder;
}

/// One experiment on its way, alone in its folder.
class Session {
 public:
  Session(const RunOptions& options, Experiment experiment);
  int run();

 private:
  void find_pending();
  int play(std::size_t job) const;
  void finish(const JobEnd& end);
  [[nodiscard]] int conclude(bool interrupted);
  void copy_twins() const;
  void report_speed() const;

  RunOptions options_;
  std::optional<FolderLock> lock_;
  Experiment experiment_;
  std::vector<Run> plan_;
  ResultStore store_;
  std::vector<std::size_t> pending_;
  /// Runs that are the same as one before, which is played in their place.
  std::vector<std::pair<std::size_t, std::size_t>> twins_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Session::Session(const RunOptions& options, Experiment experiment)
    : options_(options),
      experiment_(std::move(experiment)),
      plan_(make_plan(experiment_)),
      store_(options.out, kind_of(options.task)) {
  check_plan(plan_, experiment_.timing, options_.share);
  lock_.emplace(made(options.out));
  store_.open(settings_text(experiment_, plan_), options_.other_build);
  const auto is_other = [this](const Run& run) {
    const auto& sets = experiment_.sets;
    const auto set = std::find_if(sets.begin(), sets.end(),
                                  [&](const RunSet& one) { return one.name == run.set; });
    return !belongs_to(options_.task, set->kind);
  };
  plan_.erase(std::remove_if(plan_.begin(), plan_.end(), is_other), plan_.end());
  if (plan_.empty()) throw ConfigError(options_.file + ": sets: none is for this command");
}

int Session::play(std::size_t job) const {
  const Run& run = plan_[job];
  const Places places{options_.share, options_.out};
  const bool real = options_.task == Task::real;
  const RunResult result =
      real ? drive(run, experiment_.timing, places) : simulate(run, experiment_.timing, places);
  try {
    store_.write(run, result);
  } catch (const std::system_error& error) {
    return disk_error + error.code().value();
  }
  return 0;
}

void Session::finish(const JobEnd& end) {
  const auto stop = [&](const char* reason) {
    throw EnvironmentError(options_.out + ": " + reason +
                           "; finished runs are kept, the same command goes on");
  };
  if (end.exit_code >= disk_error) stop(std::strerror(end.exit_code - disk_error));
  if (end.signal == 0) return;
  try {
    store_.write(plan_[end.job], {std::string("killed: ") + ::strsignal(end.signal), 0, {}});
  } catch (const std::system_error& error) {
    stop(error.code().message().c_str());
  }
}

void Session::find_pending() {
  std::map<std::string, std::size_t> first;
  for (std::size_t job = 0; job < plan_.size(); ++job) {
    const auto [found, is_first] = first.emplace(identity_of(plan_[job]), job);
    if (!is_first) {
      twins_.emplace_back(job, found->second);
    } else if (!store_.read(plan_[job])) {
      pending_.push_back(job);
    }
  }
}

void Session::copy_twins() const {
  for (const auto& [twin, first] : twins_) {
    const auto result = store_.read(plan_[first]);
    if (result && !store_.read(plan_[twin])) store_.write(plan_[twin], *result);
  }
}

int Session::run() {
  find_pending();
  const std::size_t total = plan_.size() - twins_.size();
  Progress progress(total, total - pending_.size(), ::isatty(STDOUT_FILENO) == 1);
  Pool pool(options_.jobs, [this](std::size_t job) { return play(job); });
  auto next = pending_.begin();
  while (!pool.interrupted()) {
    while (next != pending_.end() && pool.has_room()) pool.start(*next++);
    const auto end = pool.wait();
    if (!end) break;
    finish(*end);
    progress.advance();
  }
  const bool interrupted = pool.interrupted();
  pool.stop();
  progress.finish();
  return conclude(interrupted);
}

int Session::conclude(bool interrupted) {
  store_.remove_drafts();
  try {
    copy_twins();
    store_.write_table(plan_);
  } catch (const std::system_error& error) {
    throw EnvironmentError(options_.out + ": " + error.code().message());
  }
  std::size_t finished = 0;
  std::size_t failed = 0;
  std::string example;
  for (const Run& run : plan_) {
    const auto result = store_.read(run);
    if (!result) continue;
    ++finished;
    if (result->failure.empty()) continue;
    ++failed;
    if (example.empty()) example = run.id() + ": " + result->failure;
  }
  if (interrupted) {
    std::printf("interrupted: %zu of %zu runs are kept in %s; the same command goes on\n", finished,
                plan_.size(), options_.out.c_str());
    return 130;
  }
  report_speed();
  if (failed == 0) return 0;
  std::fprintf(stderr, "tocsin experiment: %zu runs failed, for example %s\n", failed,
               example.c_str());
  return 1;
}

void Session::report_speed() const {
  double simulated_s = 0;
  for (const std::size_t job : pending_) {
    const auto result = store_.read(plan_[job]);
    if (result) simulated_s += result->simulated_s;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  rusage children{};
  ::getrusage(RUSAGE_CHILDREN, &children);
  const double cpu_s =
      static_cast<double>(children.ru_utime.tv_sec + children.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(children.ru_utime.tv_usec + children.ru_stime.tv_usec);
  std::printf(
      "%zu runs, %.0f s %s in %.1f s (CPU %.1f s): %.0f times real time, %.0f a core; at most %.0f "
      "MB for each of %d processes; %s\n",
      pending_.size(), simulated_s, options_.task == Task::real ? "driven" : "simulated",
      wall.count(), cpu_s, simulated_s / wall.count(), simulated_s / std::max(cpu_s, 1e-9),
      static_cast<double>(children.ru_maxrss) / 1024, options_.jobs, store_.table_path().c_str());
}

}  // namespace

int run_experiment(const RunOptions& options) {
  const bool fit = options.task == Task::fit;
  return Session(options, fit ? load_unfitted(options.file) : load_experiment(options.file)).run();
}

}  // namespace tocsin::experiment
