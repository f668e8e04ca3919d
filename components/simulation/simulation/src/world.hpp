// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "full_disk.hpp"
#include "radio_forger.hpp"
#include "runtime/middleware/log_clock.hpp"
#include "scheduler.hpp"
#include "sim_computer.hpp"
#include "sim_host.hpp"
#include "simulation/sim_world.hpp"
#include "strangers.hpp"

namespace tocsin::simulation {

/// Everything of one host; of the station of several vehicles what serves one of them, which shares
/// no topic with what serves another. Components are destroyed before the devices that they use.
struct Side {
  std::size_t vehicle = 0;  ///< of several
  std::string run_dir;
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
  [[nodiscard]] bool over() const { return exit_code() && options_.ends_with_mission; }
  [[nodiscard]] Outcome outcome(Time begin) const;
  [[nodiscard]] std::optional<int> exit_code() const;
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
  void add(const deployment::Deployment& part, std::size_t vehicle);
  void add(const deployment::Deployment& part, const deployment::Host& host, Network& network);
  void add_common();
  void add_bases(const deployment::Host& host, Side& side);
  void add(const deployment::Container& container, Side& side);
  void start(Process& process);
  Instance& add_instance(const std::string& name, Process& process);
  void schedule(Instance& instance, const Process& process);
  void exit(Process& process, int code);
  void add_second_link();
  void feed_position(const Side& side, const SimBase& base);
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
  void plan_clock_jump(const Fault& fault);
  void plan_disk(const Fault& fault);
  void plan_stop(const Fault& fault);
  void plan_rogue(const Fault& fault);
  void plan_forge(const Fault& fault);
  void ask_again(std::size_t vehicle);
  void fill_disk(bool full);
  void kill(Process& process);
  void revive(Process& process);
  void freeze(Process& process, bool frozen);
  void at(double time_s, std::function<void()> action);
  /// Of the vehicle that is the target, or of all.
  [[nodiscard]] std::vector<SimBase*> bases_of(const Fault& fault);
  /// Throws ConfigError when there is none.
  [[nodiscard]] Process& process_of(const Fault& fault);
  [[nodiscard]] std::vector<Side*> sides_of(const std::string& host);
  /// Whether it is for this vehicle: for the one that is its target, else for all.
  [[nodiscard]] bool is_of(const Fault& fault, std::size_t vehicle) const;
  /// The number of the vehicle that is the target; of the first one when none is. Throws
  /// ConfigError.
  [[nodiscard]] std::size_t vehicle_of(const Fault& fault) const;
  /// The first of this role that is of the target; throws ConfigError when there is none.
  [[nodiscard]] Side& side_of(Role role, const Fault& fault);

  deployment::Deployment deployment_;
  std::vector<deployment::Deployment> parts_;  ///< by vehicle
  deployment::Deployment common_part_;         ///< of what at the station serves all of several
  WorldOptions options_;
  RadioLink link_;
  std::optional<RadioLink> second_link_;
  std::deque<Network> networks_;   ///< by vehicle
  std::optional<Network> common_;  ///< of common_part_
  Scheduler scheduler_;
  std::list<Side> sides_;
  std::list<Process> processes_;
  std::map<std::size_t, std::unique_ptr<Person>> persons_;  ///< by vehicle, from the first stop on
  std::list<Rogue> rogues_;
  std::list<RadioForger> forgers_;
  std::optional<FullDisk> full_disk_;
  std::map<std::string, int> exit_codes_;  ///< of stop_when_exits
  Time off_air_ = Time::min();  ///< when next() last saw something to do besides the radio
};

}  // namespace tocsin::simulation
