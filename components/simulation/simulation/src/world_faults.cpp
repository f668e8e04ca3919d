// SPDX-License-Identifier: Apache-2.0
/// What a world does to itself by its fault plan.
#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "world.hpp"

namespace tocsin::simulation {
namespace {

constexpr double retry_s = 1;
constexpr double look_for_files_s = 0.1;
constexpr double ask_again_s = 0.5;  // as `tocsin estop`
constexpr double rogue_period_s = 0.05;
constexpr double forge_period_s = 0.05;

}  // namespace

void World::plan_faults() {
  for (const Fault& fault : options_.faults) plan(fault);
}

void World::plan(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::crash:
      return plan_crash(fault);
    case FaultKind::freeze:
      return plan_freeze(fault);
    case FaultKind::loss:
    case FaultKind::delay:
    case FaultKind::duplication:
      return plan_air(fault);
    case FaultKind::serial_noise:
    case FaultKind::unplug:
      return plan_serial(fault);
    case FaultKind::disk_full:
      return plan_disk(fault);
    case FaultKind::stop:
      return plan_stop(fault);
    case FaultKind::rogue_velocity:
      return plan_rogue(fault);
    case FaultKind::forge:
      return plan_forge(fault);
    case FaultKind::laser_dead:
    case FaultKind::laser_stuck:
    case FaultKind::laser_late:
    case FaultKind::laser_covered:
      return plan_laser(fault);
    case FaultKind::slip:
    case FaultKind::kidnap:
      return plan_displacement(fault);
    case FaultKind::access_point:
      return at(fault.at_s, [this, by_m = fault.amount] { link_.move_access_point(by_m); });
    case FaultKind::pose_stuck:
      return plan_stuck_pose(fault);
    case FaultKind::clock_jump:
      return plan_clock_jump(fault);
  }
}

void World::plan_clock_jump(const Fault& fault) {
  const auto sides = sides_of(fault.target);
  if (sides.empty()) throw ConfigError("faults.target: no host '" + fault.target + "'");
  for (Side* const side : sides) {
    at(fault.at_s, [side, by = seconds(fault.amount)] { side->host->jump(by); });
  }
}

void World::at(double time_s, std::function<void()> action) {
  core.events.at(core.now + seconds(time_s), std::move(action));
}

void World::plan_crash(const Fault& fault) {
  Process& process = process_of(fault);
  at(fault.at_s, [this, &process] { kill(process); });
  at(fault.at_s + fault.for_s, [this, &process] { revive(process); });
}

void World::plan_freeze(const Fault& fault) {
  Process& process = process_of(fault);
  at(fault.at_s, [this, &process] { freeze(process, true); });
  at(fault.at_s + fault.for_s, [this, &process] { freeze(process, false); });
}

void World::plan_air(const Fault& fault) {
  double AirFaults::*const which = fault.kind == FaultKind::loss    ? &AirFaults::loss
                                   : fault.kind == FaultKind::delay ? &AirFaults::delay_s
                                                                    : &AirFaults::duplication;
  for (std::size_t i = 0; i < link_.vehicles(); ++i) {
    if (!is_of(fault, i)) continue;
    at(fault.at_s, [this, i, which, amount = fault.amount] { link_.faults(i).*which = amount; });
    at(fault.at_s + fault.for_s, [this, i, which] { link_.faults(i).*which = 0; });
  }
}

void World::plan_serial(const Fault& fault) {
  const bool unplugs = fault.kind == FaultKind::unplug;
  for (SimBase* const base : bases_of(fault)) {
    at(fault.at_s, [base, unplugs, share = fault.amount] {
      unplugs ? base->unplug() : base->set_noise(share);
    });
    at(fault.at_s + fault.for_s, [base, unplugs] { unplugs ? base->plug() : base->set_noise(0); });
  }
}

void World::plan_laser(const Fault& fault) {
  for (SimBase* const base : bases_of(fault)) {
    SimLaser* const laser = base->laser();
    if (laser == nullptr) continue;
    at(fault.at_s, [laser, fault] { laser->begin(fault); });
    at(fault.at_s + fault.for_s, [laser, fault] { laser->end(fault); });
  }
}

void World::plan_displacement(const Fault& fault) {
  for (SimBase* const base : bases_of(fault)) {
    if (fault.kind == FaultKind::kidnap) {
      at(fault.at_s, [base, most_m = fault.amount] { base->carry_off(most_m); });
    } else {
      at(fault.at_s, [base, share = fault.amount] { base->set_slip(share); });
      at(fault.at_s + fault.for_s, [base] { base->set_slip(0); });
    }
  }
}

void World::plan_stuck_pose(const Fault& fault) {
  for (SimBase* const base : bases_of(fault)) {
    at(fault.at_s, [base] { base->hold_true_pose(true); });
    at(fault.at_s + fault.for_s, [base] { base->hold_true_pose(false); });
  }
}

void World::plan_disk(const Fault& fault) {
  // Again and again, for the files that are opened meanwhile.
  for (double time_s = fault.at_s; time_s < fault.at_s + fault.for_s; time_s += look_for_files_s) {
    at(time_s, [this] { fill_disk(true); });
  }
  at(fault.at_s + fault.for_s, [this] { fill_disk(false); });
}

void World::plan_stop(const Fault& fault) {
  const std::size_t vehicle = vehicle_of(fault);
  SimHost& station = *side_of(Role::gcs, fault).host;
  at(fault.at_s, [this, vehicle, &station] {
    auto& person = persons_[vehicle];
    if (!person) {
      person = std::make_unique<Person>(station.add_process("person"));
      at(ask_again_s, [this, vehicle] { ask_again(vehicle); });
    }
    person->press();
  });
  at(fault.at_s + fault.for_s, [this, vehicle] { persons_.at(vehicle)->release(); });
}

void World::ask_again(std::size_t vehicle) {
  persons_.at(vehicle)->ask();
  at(ask_again_s, [this, vehicle] { ask_again(vehicle); });
}

void World::plan_rogue(const Fault& fault) {
  SimHost& vehicle = *side_of(Role::uxv, fault).host;
  Rogue& rogue = rogues_.emplace_back();
  const std::string name = "rogue_" + std::to_string(rogues_.size());
  at(fault.at_s, [&rogue, &vehicle, name] { rogue.begin(vehicle.add_process(name)); });
  for (double passed_s = 0; passed_s < fault.for_s; passed_s += rogue_period_s) {
    at(fault.at_s + passed_s, [&rogue] { rogue.drive(); });
  }
  at(fault.at_s + fault.for_s, [&rogue] { rogue.end(); });
}

void World::plan_forge(const Fault& fault) {
  RadioForger& forger = forgers_.emplace_back(networks_[vehicle_of(fault)],
                                              static_cast<std::uint64_t>(deployment_.seed));
  at(fault.at_s, [&forger] { forger.begin(); });
  for (double passed_s = forge_period_s; passed_s < fault.for_s; passed_s += forge_period_s) {
    at(fault.at_s + passed_s, [&forger] { forger.speak(); });
  }
  at(fault.at_s + fault.for_s, [&forger] { forger.end(); });
}

void World::fill_disk(bool full) {
  full_disk_.reset();
  if (full) full_disk_.emplace(deployment_.run_dir);
}

void World::kill(Process& process) {
  if (process.bus == nullptr || process.exit_code) return;
  const bool full = full_disk_.has_value();
  fill_disk(false);  // descriptors are about to be closed
  core.dying = true;
  for (const Instance& one : process.instances) {
    if (one.component) scheduler_.remove(*one.component);
  }
  while (!process.instances.empty()) process.instances.pop_back();
  core.dying = false;
  process.bus->die();
  process.bus = nullptr;
  process.frozen = false;
  fill_disk(full);
  tell(process, ProcessEvent::killed);
}

void World::revive(Process& process) {
  if (process.bus != nullptr || process.exit_code) return;
  try {
    start(process);
    tell(process, ProcessEvent::started);
  } catch (const std::exception& error) {
    if (Observer* const observer = core.observer(process.side->vehicle)) {
      observer->on_failure(process.path, error.what(), core.now);
    }
    kill(process);
    at(retry_s, [this, &process] { revive(process); });
  }
}

/// A dead one is neither; its successor is never born frozen.
void World::freeze(Process& process, bool frozen) {
  if (process.bus == nullptr || process.exit_code || process.frozen == frozen) return;
  process.frozen = frozen;
  process.bus->freeze(frozen);
  for (const Instance& one : process.instances) {
    if (one.component) scheduler_.freeze(*one.component, frozen);
  }
  tell(process, frozen ? ProcessEvent::frozen : ProcessEvent::thawed);
}

World::Process& World::process_of(const Fault& fault) {
  const auto found = std::find_if(processes_.begin(), processes_.end(),
                                  [&](const Process& one) { return one.path == fault.target; });
  if (found != processes_.end()) return *found;
  throw ConfigError("faults.target: no process '" + fault.target + "'");
}

std::vector<SimBase*> World::bases_of(const Fault& fault) {
  std::vector<SimBase*> found;
  for (Side& side : sides_) {
    if (!is_of(fault, side.vehicle)) continue;
    for (SimBase& base : side.bases) found.push_back(&base);
  }
  return found;
}

bool World::is_of(const Fault& fault, std::size_t vehicle) const {
  const bool is_named = !deployment_.vehicles.empty() && !fault.target.empty();
  return !is_named || vehicle_of(fault) == vehicle;
}

std::size_t World::vehicle_of(const Fault& fault) const {
  if (fault.target.empty() || deployment_.vehicles.empty()) return 0;
  for (const Side& side : sides_) {
    if (side.host->role() == Role::uxv && side.host->name() == fault.target) return side.vehicle;
  }
  throw ConfigError("faults.target: no vehicle '" + fault.target + "'");
}

Side& World::side_of(Role role, const Fault& fault) {
  for (Side& side : sides_) {
    if (side.host->role() == role && side.vehicle == vehicle_of(fault)) return side;
  }
  throw ConfigError(std::string("faults.kind: there is no host of role ") + to_string(role));
}

std::vector<Side*> World::sides_of(const std::string& host) {
  std::vector<Side*> found;
  for (Side& side : sides_) {
    if (side.host->name() == host) found.push_back(&side);
  }
  return found;
}

}  // namespace tocsin::simulation
