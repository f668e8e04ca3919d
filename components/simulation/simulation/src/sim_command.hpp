// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "command_line/bringup_options.hpp"
#include "deployment/deployment.hpp"
#include "simulation/campaign.hpp"

/// What `tocsin sim` does.
namespace tocsin::simulation {

struct Options : BringupOptions {
  double duration_s = 3600;
  bool verify = false;
  std::string faults;  ///< empty, "random" or a path
  bool check = false;
  InvariantLimits limits;
  bool until_failure = false;
  std::string seeds;  ///< "A..B"; empty: one run
  unsigned jobs = 1;
  std::string replay;  ///< the words of the command line that a replay repeats
};

/// By `--faults`: none, drawn from the seed, or read.
[[nodiscard]] FaultPlan faults_of(const Options& options, const deployment::Deployment& deployment);

/// One run, or two with `verify`. The exit code is that of the mission; 1 for a broken promise.
int simulate(const Options& options);

/// Many checked runs: prints the first seed that breaks a promise, or all; exit code 1 for any.
int search_seeds(const Options& options);

}  // namespace tocsin::simulation
