// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "simulation/invariants.hpp"

namespace tocsin::simulation {

/// What became of one checked run.
struct SeedOutcome {
  std::uint64_t seed = 0;
  Outcome outcome;
  FaultPlan faults;
  std::vector<Violation> violations;
  std::uint64_t checks = 0;
};

/// Runs a world with faults until the mission is over, at most `limits.recovers_s` after the
/// last of them, and checks the promises, of several vehicles to each. Throws as SimWorld does.
[[nodiscard]] SeedOutcome run_checked(const deployment::Deployment& deployment,
                                      WorldOptions options, const InvariantLimits& limits = {});

/// Whether every promise was kept. A text for people, one line per violation.
[[nodiscard]] std::string to_text(const SeedOutcome& checked);

struct Search {
  std::uint64_t first = 1;
  std::uint64_t last = 1000;
  unsigned jobs = 1;  ///< threads
  bool until_failure = true;
};

struct SearchResult {
  std::uint64_t runs = 0;
  std::uint64_t checks = 0;
  Duration simulated{0};
  /// In the order of seeds. With `until_failure` at most one, and no seed before it breaks any.
  std::vector<SeedOutcome> broken;
};

/// Runs seeds side by side. `run` is called from several threads; what it throws, this throws.
[[nodiscard]] SearchResult search(const Search& search,
                                  const std::function<SeedOutcome(std::uint64_t seed)>& run);

}  // namespace tocsin::simulation
