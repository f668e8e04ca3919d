// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"

namespace tocsin::simulation {

/// What goes wrong.
enum class FaultKind : std::uint8_t {
  crash,         ///< the process host/name dies like by kill -9, and is started again after `for_s`
  loss,          ///< a share `amount` of the packets of the radio is lost in addition
  delay,         ///< packets come up to `amount` seconds later, and so in another order
  duplication,   ///< a share `amount` of the packets comes twice
  clock_jump,    ///< the wall clock of the host `target` is put `amount` seconds on, for good
  serial_noise,  ///< a share `amount` of the bytes from the base is flipped, lost or invented
  unplug,        ///< the base's serial port is gone
  disk_full,     ///< files of the run folder that grow take nothing
  stop,  ///< a person at the station presses the emergency stop, and releases it after `for_s`
  rogue_velocity,  ///< somebody on the vehicle's host publishes cmd_vel besides the driver's own
                   ///< chain
  freeze,          ///< the process host/name computes nothing for `for_s`, as by kill -STOP
  forge,           ///< somebody on the radio speaks in the routers' names, without their secrets
  laser_dead,      ///< the laser's serial port is gone
  laser_stuck,     ///< the laser repeats its last turn
  laser_late,      ///< the laser's bytes come `amount` seconds later
  laser_covered,   ///< the left half of the laser measures nothing
  slip,            ///< a share `amount` of what the wheels turn does not move the vehicle
  kidnap,          ///< the vehicle is put to a free place up to `amount` metres away, for good
  access_point,    ///< the access point is put `amount` metres along x, for good
  pose_stuck,      ///< modelled_localiser says the same place again and again
};

/// One fault, at a time after the start of the run.
struct Fault {
  FaultKind kind = FaultKind::loss;
  double at_s = 0;     ///< [s] from 0
  double for_s = 0;    ///< [s] more than 0
  std::string target;  ///< a process, or a host; of several vehicles the one, or empty: all of them
  double amount = 0;
};

/// Sorted by time.
using FaultPlan = std::vector<Fault>;

/// One to six faults between 2 s and 60 s, each over after at most 10 s; the same for the same seed
/// and processes. Processes that own the terminal do not crash.
///
/// Besides them, in every second run, a stop, and in the half of these somebody who publishes
/// velocities meanwhile; in every third run a router is frozen, in every fourth somebody forges.
/// Where the base has a laser, something is wrong with it in every second run; where a localiser
/// runs, the wheels slip in every third and the vehicle is carried off in every fourth. Where a
/// link_mapper runs, the access point is moved in every third, by 2 to 8 m: farther, and a vehicle
/// may stand where it has no link ever again; where a modelled_localiser runs, it is stuck in every
/// third.
/// Of several vehicles each has faults of its own.
/// These are drawn from numbers of their own: a kind that is added does not change what a seed
/// draws of the others.
[[nodiscard]] FaultPlan random_faults(std::uint64_t seed, const deployment::Deployment& deployment);

/// Reads `faults: [{kind: crash, at_s: 12, for_s: 1, target: uxv/drive}, ...]`. Throws ConfigError
/// naming file, line, key and value.
[[nodiscard]] FaultPlan load_faults(const std::string& path);

/// The text that load_faults reads, one fault a line.
[[nodiscard]] std::string to_yaml(const FaultPlan& plan);

/// When the last one is over [s]; 0 for an empty plan.
[[nodiscard]] double end_of(const FaultPlan& plan);

}  // namespace tocsin::simulation
