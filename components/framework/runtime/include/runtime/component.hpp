// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "ros_idl/builtin_interfaces.hpp"
#include "runtime/bus.hpp"
#include "runtime/devices.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/turn_lock.hpp"

namespace tocsin {

/// What a component is given at construction.
struct Context {
  Bus& bus;
  std::string name;     ///< instance name, from the bringup file
  std::string role;     ///< side of the link: uxv or gcs
  std::string run_dir;  ///< folder for files of this run; exists
  /// Ends the process with this code after the current tick; 0 is "my work is done".
  std::function<void(int)> request_exit = [](int) {};
  Devices* devices = nullptr;  ///< of a simulated computer; null: the real ones
};

/// What sleeps until a component has something to do.
class Waker {
 public:
  /// Any thread; must not block.
  virtual void wake() = 0;
  /// The waker whose thread this is needs no waking: it looks before it sleeps.
  void claim_this_thread() const;

 protected:
  ~Waker() = default;
};

/// When a component runs next. The component asks through its protected functions; the runner
/// reads. Only `input_arrived` and `set_waker` may be called from another thread.
struct Schedule {
  std::atomic<bool> input_pending{false};  ///< one that another thread has delivered
  Time deadline = never;
  Duration period{0};
  Time next_period = never;
  std::atomic<std::uint64_t> overruns{0};  ///< periods that were skipped: a tick came too late
  std::vector<int> descriptors;
  void input_arrived();
  /// `waker` is woken by the first input after each tick; null ends that, and waits for a call
  /// that is running. Between two wakers the component does not listen.
  void set_waker(Waker* waker);
  /// Since the last tick began, an input came.
  [[nodiscard]] bool has_input() const { return own_input_ || input_pending; }
  /// The next instant at which a tick is due without input.
  [[nodiscard]] Time due() const { return std::min(deadline, next_period); }
  /// Forgets what the tick at `now` answers to.
  void begin_tick(Time now);
  /// From the last tick on, or from the first one that comes.
  void repeat(Duration wanted);

 private:
  Time begun_ = never;
  std::atomic<bool> own_input_{false};  // delivered and looked at by the waker's thread alone
  TurnLock wake_turn_;
  std::atomic<Waker*> waker_{nullptr};
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
  explicit Component(Context& context) : context_(context), log_(context.name) {}
  virtual ~Component() = default;
  /// Runs after an input came, a deadline passed or a descriptor became readable, and once at
  /// start. `now` never decreases. Takes inputs, calls the decision, writes outputs.
  virtual void tick(Time now) = 0;

  [[nodiscard]] const std::string& name() const { return context_.name; }
  [[nodiscard]] Bus& bus() { return context_.bus; }
  [[nodiscard]] Schedule& schedule() { return schedule_; }
  /// For the container, any thread: account of all inputs; ending and resuming their supply.
  [[nodiscard]] std::vector<PortHealth> port_health() const;
  void listen(bool on);

 protected:
  /// Tick not later than `deadline`. The earliest wish since the start of the last tick counts;
  /// every tick forgets it, so ask again.
  void wake_at(Time deadline);
  /// Tick each `period` (> 0) from now on; a missed one is skipped, not caught up.
  void wake_every(Duration period) { schedule_.repeat(period); }
  /// Tick whenever `descriptor` is readable, until `forget`. The caller keeps ownership.
  void wake_on(int descriptor) { schedule_.descriptors.push_back(descriptor); }
  void forget(int descriptor);
  /// Wall time at `now`, for the stamp of a message.
  [[nodiscard]] builtin_interfaces::msg::Time wall(Time now) const;
  [[nodiscard]] const Context& context() const { return context_; }
  [[nodiscard]] Logger& log() { return log_; }

 private:
  friend class InputPort;
  void add_port(InputPort& port);
  void remove_port(InputPort& port);
  Context& context_;
  Schedule schedule_;
  Logger log_;
  mutable std::mutex ports_mutex_;
  std::vector<InputPort*> ports_;
};

}  // namespace tocsin
