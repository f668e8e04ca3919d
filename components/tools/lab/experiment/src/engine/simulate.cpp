// SPDX-License-Identifier: Apache-2.0
#include "engine/simulate.hpp"

#include <exception>
#include <utility>

#include "engine/recording_observer.hpp"
#include "simulation/sim_world.hpp"

namespace tocsin::experiment {
namespace {

simulation::SimWorld make_world(const Run& run, const Timing& timing, const Places& places,
                                simulation::Observer* observer) {
  auto deployment = deployment_of(run, timing, places.share, places.folder);
  instrument(deployment);
  simulation::WorldOptions options;
  options.digest = false;
  options.observer = observer;
  return simulation::SimWorld(std::move(deployment), options);
}

RunResult play(const Run& run, const Timing& timing, const Places& places) {
  RecordingObserver observer;
  simulation::SimWorld world = make_world(run, timing, places, &observer);
  const auto outcome = world.run(seconds(timing.duration_s));
  report::Recording& recording = observer.recording();
  recording.begin_s = recording.link.empty() ? 0 : recording.link.front().time_s;
  recording.end_s = recording.begin_s + to_seconds(outcome.simulated);
  return {observer.failure(), to_seconds(outcome.simulated), measure(recording, timing)};
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
