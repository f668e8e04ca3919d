// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "foundation/error.hpp"
#include "sim_command.hpp"

namespace tocsin::simulation {
namespace {

namespace fs = std::filesystem;

/// The components' log goes nowhere as long as this lives: a thousand runs write too much.
class Quiet {
 public:
  Quiet() : kept_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~Quiet() {
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  int kept_;
};

/// Made new, and removed with all that is in it.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::uint64_t seed)
      : path_(memory_or_disk() /
              ("tocsin_sim_" + std::to_string(::getpid()) + "_" + std::to_string(seed))) {
    fs::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code gone;
    fs::remove_all(path_, gone);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  /// In memory where there is such a place: components save their state several times a second,
  /// and a disk may make each of them wait.
  static fs::path memory_or_disk() {
    const fs::path memory = "/dev/shm";
    return fs::is_directory(memory) ? memory : fs::temp_directory_path();
  }
  fs::path path_;
};

Search read_search(const Options& options) {
  Search search;
  search.jobs = options.jobs;
  search.until_failure = options.until_failure;
  if (options.seeds.empty()) return search;
  unsigned long long first = 0;
  unsigned long long last = 0;
  char rest = 0;
  const int read = std::sscanf(options.seeds.c_str(), "%llu..%llu%c", &first, &last, &rest);
  if (read != 2 || first > last || last > 2147483647ULL) {
    throw ConfigError("--seeds: '" + options.seeds + "' is not A..B with 0 <= A <= B < 2^31");
  }
  search.first = first;
  search.last = last;
  return search;
}

SeedOutcome run_seed(const Options& options, std::uint64_t seed) {
  const ScratchFolder folder(seed);
  deployment::Overrides overrides = options.overrides;
  overrides.run_dir = folder.path();
  overrides.seed = static_cast<int>(seed);
  auto deployment = deployment::load_deployment(options.file, overrides);
  WorldOptions world;
  world.digest = false;
  world.faults = faults_of(options, deployment);
  return run_checked(std::move(deployment), world, options.limits);
}

void print(const SeedOutcome& checked, const Options& options) {
  std::printf("seed %llu breaks %zu:\n%s%sreplay: %s --seed %llu --check\n",
              static_cast<unsigned long long>(checked.seed), checked.violations.size(),
              to_text(checked).c_str(), to_yaml(checked.faults).c_str(), options.replay.c_str(),
              static_cast<unsigned long long>(checked.seed));
}

}  // namespace

int search_seeds(const Options& options) {
  const Search wanted = read_search(options);
  const auto begin = std::chrono::steady_clock::now();
  SearchResult result;
  {
    const Quiet quiet;
    result = search(wanted, [&](std::uint64_t seed) { return run_seed(options, seed); });
  }
  for (const SeedOutcome& checked : result.broken) print(checked, options);
  const double wall_s = to_seconds(Duration(std::chrono::steady_clock::now() - begin));
  std::printf("%llu runs, %.0f s simulated in %.1f s, %llu checks: %zu runs broke a promise\n",
              static_cast<unsigned long long>(result.runs), to_seconds(result.simulated), wall_s,
              static_cast<unsigned long long>(result.checks), result.broken.size());
  return result.broken.empty() ? 0 : 1;
}

}  // namespace tocsin::simulation
