// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/computer.hpp"
#include "foundation/role.hpp"
#include "foundation/time.hpp"
#include "ros_idl/builtin_interfaces.hpp"
#include "runtime/bus.hpp"
#include "runtime/detail/schedule.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

/// What a component is given at construction. What is not said by name is as it is for a component
/// that runs alone: no folder, nothing that it can end, this computer.
struct Context {
  Context(Bus& its_bus, std::string its_name, Role its_role)
      : bus(its_bus), name(std::move(its_name)), role(its_role) {}

  Bus& bus;
  std::string name;     ///< instance name, from the bringup file
  Role role;            ///< of its host
  std::string run_dir;  ///< folder for files of this run, which exists; empty: there is none
  /// Ends the process with this code after the current tick; 0 is "my work is done".
  std::function<void(int)> request_exit = [](int) {};
  std::reference_wrapper<const Computer> computer = this_computer();
  std::uint64_t seed = 0;  ///< of the process, from the run's: see process_seed
  std::string node;        ///< what ROS 2 calls it; empty: `name`

  [[nodiscard]] Context with_run_dir(std::string folder) const;
  [[nodiscard]] Context with_request_exit(std::function<void(int)> request) const;
  [[nodiscard]] Context with_computer(const Computer& its_computer) const;
  [[nodiscard]] Context with_seed(std::uint64_t its_seed) const;
  [[nodiscard]] Context with_node(std::string its_node) const;

  /// Those of its computer.
  [[nodiscard]] const Devices& devices() const { return computer.get().devices; }
  /// The file that this instance keeps for its successor, as ".pose"; empty where none is kept.
  [[nodiscard]] std::string state_path(const std::string& extension) const;
};

/// Account of one input since start.
struct PortHealth {
  std::string topic;
  std::uint64_t received = 0;
  std::uint64_t dropped = 0;  ///< pushed out of the full queue before the component took it
  std::size_t depth = 0;      ///< waiting now
  Time last{};                ///< when the last one came; zero: none yet
};

class InputPort;

/// A part of the vehicle: ports, parameters and a decision.
///
/// Complete after its constructor, which may throw ConfigError; after that nothing may throw.
/// One thread calls `tick`, so a component needs no lock; it never sleeps and reads no clock.
class Component {
 public:
  explicit Component(Context& context);
  virtual ~Component() = default;
  /// Runs after an input came, a deadline passed or a descriptor became readable, and once at
  /// start. `now` never decreases. Takes inputs, calls the decision, writes outputs.
  virtual void tick(Time now) = 0;

  [[nodiscard]] const std::string& name() const { return context_.name; }
  /// What ROS 2 calls it.
  [[nodiscard]] const std::string& node() const {
    return context_.node.empty() ? context_.name : context_.node;
  }
  [[nodiscard]] Bus& bus() { return context_.bus; }
  [[nodiscard]] Schedule& schedule() { return schedule_; }
  /// When to do next what is done each `period` (> 0) and is done now: half to one and a half
  /// periods from now, at this component's own phase of the bus's clock, so that the components of
  /// a run, which start together, do not send together for as long as it lasts.
  [[nodiscard]] Time next_instant(Duration period, Time now) const;
  /// For the container, any thread: account of all inputs; ending and resuming their supply.
  [[nodiscard]] std::vector<PortHealth> port_health() const;
  void listen(bool on);
  /// For the container, any thread: `change` is done on the component's thread before its next
  /// tick, which it asks for.
  void post(std::function<void()> change);
  /// For who ticks it, before the tick: does what was posted.
  void take_changes() {
    if (has_changes_) do_changes();
  }

 protected:
  /// Tick not later than `deadline`. The earliest wish since the start of the last tick counts;
  /// every tick forgets it, so ask again.
  void wake_at(Time deadline);
  /// Tick each `period` (> 0) from now on, at its next_instant; a missed one is skipped.
  void wake_every(Duration period) { schedule_.repeat({period, phase_}); }
  /// Tick whenever `descriptor` is readable, until `forget`. The caller keeps ownership. Empty:
  /// there is nothing to poll, see Device.
  void wake_on(std::optional<int> descriptor);
  void forget(std::optional<int> descriptor);
  /// What a device without a descriptor calls when something came: tick.
  [[nodiscard]] Devices::Readable when_readable();
  /// Wall time at `now`, for the stamp of a message.
  [[nodiscard]] builtin_interfaces::msg::Time wall(Time now) const;
  [[nodiscard]] const Context& context() const { return context_; }
  [[nodiscard]] Logger& log() { return log_; }

 private:
  friend class InputPort;
  void add_port(InputPort& port);
  void remove_port(InputPort& port);
  void do_changes();
  Context& context_;
  const double phase_;
  Schedule schedule_;
  Logger log_;
  mutable std::mutex ports_mutex_;
  std::vector<InputPort*> ports_;
  std::atomic<bool> has_changes_{false};
  std::mutex changes_mutex_;
  std::vector<std::function<void()>> changes_;
};

}  // namespace tocsin
