// SPDX-License-Identifier: Apache-2.0
#include "simulate.hpp"

#include <exception>

#include "experiment/tape.hpp"
#include "simulation/sim_world.hpp"

namespace tocsin::experiment {
namespace {

RunResult play(const Run& run, const Timing& timing, const Places& places) {
  auto deployment = deployment_of(run, timing, places.share, places.folder);
  instrument(deployment);
  Tape tape;
  simulation::WorldOptions options;
  options.digest = false;
  options.observer = &tape;
  simulation::SimWorld world(std::move(deployment), options);
  const auto outcome = world.run(seconds(timing.duration_s));
  report::Recording& recording = tape.recording();
  recording.begin_s = recording.link.empty() ? 0 : recording.link.front().time_s;
  recording.end_s = recording.begin_s + to_seconds(outcome.simulated);
  return {tape.failure(), to_seconds(outcome.simulated), measure(recording, timing)};
}

}  // namespace

RunResult simulate(const Run& run, const Timing& timing, const Places& places) {
  try {
    return play(run, timing, places);
  } catch (const std::exception& error) {
    return {error.what(), 0, {}};
  }
}

}  // namespace tocsin::experiment
