// SPDX-License-Identifier: Apache-2.0
#include "simulation/campaign.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace tocsin::simulation {
namespace {

/// What the threads of a search share.
class Work {
 public:
  Work(const Search& wanted, const std::function<SeedOutcome(std::uint64_t)>& run)
      : wanted_(wanted), run_(run), next_(wanted.first) {}

  void work() {
    while (const auto seed = take()) {
      try {
        put(run_(*seed));
      } catch (...) {
        stop(std::current_exception());
      }
    }
  }
  SearchResult result() {
    if (error_) std::rethrow_exception(error_);
    auto& broken = result_.broken;
    std::sort(broken.begin(), broken.end(),
              [](const SeedOutcome& a, const SeedOutcome& b) { return a.seed < b.seed; });
    if (wanted_.until_failure && broken.size() > 1) broken.resize(1);
    return std::move(result_);
  }

 private:
  std::optional<std::uint64_t> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool found = wanted_.until_failure && !result_.broken.empty();
    if (found || error_ || next_ > wanted_.last) return std::nullopt;
    return next_++;
  }
  void put(SeedOutcome checked) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++result_.runs;
    result_.checks += checked.checks;
    result_.simulated += checked.outcome.simulated;
    if (!checked.violations.empty()) result_.broken.push_back(std::move(checked));
  }
  void stop(std::exception_ptr error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = std::move(error);
  }

  const Search wanted_;
  const std::function<SeedOutcome(std::uint64_t)>& run_;
  std::mutex mutex_;
  std::uint64_t next_;
  SearchResult result_;
  std::exception_ptr error_;
};

/// With the exit code of the vehicle's own processes.
Outcome outcome_of(const deployment::Deployment& part, Outcome whole) {
  whole.exit_code.reset();
  for (const std::string& process : part.stop_when_exits) {
    const auto found = whole.exit_codes.find(process);
    if (found == whole.exit_codes.end()) return whole;  // not over
    whole.exit_code = std::max(whole.exit_code.value_or(0), found->second);
  }
  return whole;
}

}  // namespace

SeedOutcome run_checked(const deployment::Deployment& deployment, WorldOptions options,
                        const InvariantLimits& limits) {
  const double last_fault_s = end_of(options.faults);
  const auto parts = parts_of(deployment);
  std::deque<Invariants> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    options.observers.push_back(&all.emplace_back(limits));
  }
  SeedOutcome checked;
  checked.seed = static_cast<std::uint64_t>(deployment.seed);
  checked.faults = options.faults;
  {
    SimWorld world(deployment, options);
    checked.outcome = world.run(seconds(last_fault_s + limits.recovers_s));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Invariants& invariants = all[i];
    const Outcome own = outcome_of(parts[i], checked.outcome);
    invariants.on_end(own);
    invariants.on_logs(parts[i].run_dir, own);
    const auto& broken = invariants.violations();
    checked.violations.insert(checked.violations.end(), broken.begin(), broken.end());
    checked.checks += invariants.checks();
  }
  return checked;
}

std::string to_text(const SeedOutcome& checked) {
  std::string text;
  for (const Violation& violation : checked.violations) {
    char time[40];
    std::snprintf(time, sizeof time, "%10.3f s  ", violation.at_s);
    text += time + violation.text + "\n";
  }
  return text;
}

SearchResult search(const Search& search, const std::function<SeedOutcome(std::uint64_t)>& run) {
  Work work(search, run);
  std::vector<std::thread> others;
  for (unsigned i = 1; i < search.jobs; ++i) others.emplace_back([&work] { work.work(); });
  work.work();
  for (std::thread& other : others) other.join();
  return work.result();
}

}  // namespace tocsin::simulation
