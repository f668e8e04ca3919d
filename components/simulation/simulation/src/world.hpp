// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "full_disk.hpp"
#include "radio_forger.hpp"
#include "runtime/middleware/log_clock.hpp"
#include "scheduler.hpp"
#include "sim_computer.hpp"
#include "sim_host.hpp"
#include "simulation/sim_world.hpp"
#include "strangers.hpp"

namespace tocsin::simulation {

/// Everything of one host. Components are destroyed before the devices that they use.
struct Side {
  std::unique_ptr<SimHost> host;
  std::unique_ptr<SimComputer> computer;
  std::list<SimBase> bases;
};

/// All of a simulated world: hosts, processes and components of a bringup file.
class World {
 public:
  World(deployment::Deployment deployment, const WorldOptions& options);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// When something is to be done next.
  [[nodiscard]] Time next();
  /// Does all that is due at `now`.
  void step(Time now);
  [[nodiscard]] bool over() const { return exit_code_ && options_.ends_with_mission; }
  [[nodiscard]] Outcome outcome(Time begin) const;
  Core core;
  LogClock log_clock;  ///< to be used while it steps

 private:
  struct Instance {
    Context context;
    std::unique_ptr<Component> component;
  };
  /// A container; its life begins anew after each crash.
  struct Process {
    std::string path;  ///< host/name
    const deployment::Container* container;
    Side* side;
    SimProcess* bus = nullptr;  ///< null: dead
    int lives = 0;
    bool frozen = false;
    std::optional<int> exit_code;
    std::list<Instance> instances;
  };

  [[nodiscard]] bool wanted(const deployment::ComponentInstance& one) const;
  void add(const deployment::Host& host);
  void add_bases(const deployment::Host& host, Side& side);
  void add(const deployment::Container& container, Side& side);
  void start(Process& process);
  Instance& add_instance(const std::string& name, Process& process);
  void schedule(Instance& instance, const Process& process);
  void exit(Process& process, int code);
  void add_second_link();
  void feed_position(const std::string& host, const SimBase& base);
  void tell(const Process& process, ProcessEvent event) const;

  // Faults.
  void plan_faults();
  void plan(const Fault& fault);
  void plan_crash(const Fault& fault);
  void plan_freeze(const Fault& fault);
  void plan_air(const Fault& fault);
  void plan_serial(const Fault& fault);
  void plan_laser(const Fault& fault);
  void plan_displacement(const Fault& fault);
  void plan_stuck_pose(const Fault& fault);
  void plan_disk(const Fault& fault);
  void plan_stop(const Fault& fault);
  void plan_rogue(const Fault& fault);
  void plan_forge(const Fault& fault);
  void ask_again();
  void fill_disk(bool full);
  void kill(Process& process);
  void revive(Process& process);
  void freeze(Process& process, bool frozen);
  void at(double time_s, std::function<void()> action);
  /// Throws ConfigError when there is none.
  [[nodiscard]] Process& process_of(const Fault& fault);
  [[nodiscard]] Side* find_side(const std::string& host);
  /// The first of this role; throws ConfigError when there is none.
  [[nodiscard]] Side& side_of(Role role);

  deployment::Deployment deployment_;
  WorldOptions options_;
  RadioLink link_;
  std::optional<RadioLink> second_link_;
  Network network_;
  Scheduler scheduler_;
  std::list<Side> sides_;
  std::list<Process> processes_;
  std::unique_ptr<Person> person_;  ///< at the station, from the first stop on
  std::list<Rogue> rogues_;
  std::list<RadioForger> forgers_;
  std::optional<FullDisk> full_disk_;
  std::optional<int> exit_code_;
  Time off_air_ = Time::min();  ///< when next() last saw something to do besides the radio
};

}  // namespace tocsin::simulation
