// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "foundation/time.hpp"
#include "simulation/faults.hpp"
#include "simulation/observer.hpp"

namespace tocsin::simulation {

/// How a simulated run ended.
struct Outcome {
  Duration simulated{0};
  /// Highest exit code of the processes that the bringup file stops with; empty: the duration was
  /// over.
  std::optional<int> exit_code;
  /// Of those processes, by name, that have ended; with several vehicles there is one for each.
  std::map<std::string, int> exit_codes = {};
  std::uint64_t samples = 0;  ///< written, on all topics of all hosts
  std::uint64_t packets = 0;  ///< pushed onto the radio
  std::uint64_t ticks = 0;    ///< of components
  std::uint64_t digest = 0;   ///< over (time, writer, bytes) of every sample written; 0: off
};

/// What to compute, and what to leave out, of a world.
struct WorldOptions {
  bool digest = true;
  Observer* observer = nullptr;  ///< outlives the world
  /// In place of it one for each of several vehicles, in their order: what happens to it, and
  /// between it and the station.
  std::vector<Observer*> observers = {};
  /// Component libraries that are not built, such as recorder. What a live_view reads is no longer
  /// sent to it, which changes the traffic on the radio.
  std::vector<std::string> without;
  /// False: the run goes on when the processes of `stop_when_exits` have ended.
  bool ends_with_mission = true;
  FaultPlan faults;  ///< with crashes, components keep files for a restart in the run folder
};

class World;

/// A whole bringup in virtual time, on one thread: its unmodified components, the base's model in
/// place of the kobuki_simulator program, the radio channel's model in place of the link emulator.
///
///     simulation::SimWorld world(deployment::load_deployment("mission.yaml", overrides));
///     const simulation::Outcome outcome = world.run(seconds(600));
///
/// The same deployment (seed included) gives the same samples at the same times: compare digests.
/// Reads no clock. Several worlds may exist in a process, each with a thread of its own.
class SimWorld {
 public:
  /// Builds every component. Those of a container that owns the terminal are not ticked, but what
  /// they read is sent to them. `run_dir` of the deployment must exist; the recorders write there.
  /// Throws ConfigError as the components do, and for a program that has no model.
  explicit SimWorld(deployment::Deployment deployment, const WorldOptions& options = {});
  ~SimWorld();
  SimWorld(const SimWorld&) = delete;
  SimWorld& operator=(const SimWorld&) = delete;

  /// Runs until the processes of `stop_when_exits` have ended (unless the options say otherwise) or
  /// the virtual clock has gone on by exactly `limit`. May be called again after the limit. A
  /// component that throws is ticked no more, like in a container; one that never comes to rest at
  /// one instant throws std::runtime_error.
  Outcome run(Duration limit);

 private:
  std::unique_ptr<World> world_;
};

}  // namespace tocsin::simulation
