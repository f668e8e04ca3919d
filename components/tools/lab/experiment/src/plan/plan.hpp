// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "plan/experiment_file.hpp"

namespace tocsin::experiment {

/// One run of the plan.
struct Run {
  std::size_t number = 0;  ///< place in the plan, from 0
  std::string set;
  Mission mission;
  Channel channel;  ///< its path with the mission's name put in
  Payload payload;
  PolicyChoice policy;
  int index = 1;                    ///< number of the seed
  int seed = 1;                     ///< decides everything random
  std::vector<std::string> fitted;  ///< settings of the controller, below those of the policy

  /// "thesis.a.classroom.camera.none.7": unique, the name of its files.
  [[nodiscard]] std::string id() const;
};

/// Everything that decides a run; equal for runs of two sets that are the same run.
[[nodiscard]] std::string identity_of(const Run& run);

/// All runs, in the order of the file: set, mission, channel, payload, policy, seed. Runs of two
/// sets that are the same run are both there. Throws ConfigError when a channel's file is missing.
[[nodiscard]] std::vector<Run> make_plan(const Experiment& experiment);

/// The seed of run `index`: the same for every policy and payload, so that all meet one radio.
[[nodiscard]] int seed_of(const std::string& mission, const std::string& channel, int index);

/// What the command line of `tocsin launch` would say for this run. Reads the bringup file when the
/// payload has no camera, to find those that are left out; throws ConfigError as that does.
[[nodiscard]] deployment::Overrides overrides_of(const Run& run, const Timing& timing,
                                                 const std::string& share,
                                                 const std::string& run_dir);

/// The bringup of a run as it is started in reality. Throws ConfigError.
[[nodiscard]] deployment::Deployment deployment_of(const Run& run, const Timing& timing,
                                                   const std::string& share,
                                                   const std::string& run_dir);

/// Makes it a simulated run: each recorder gives way to a Listener.
void instrument(deployment::Deployment& deployment);

}  // namespace tocsin::experiment
