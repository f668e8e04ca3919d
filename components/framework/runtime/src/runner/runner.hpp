// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "runner/sleeper.hpp"
#include "runner/tick_account.hpp"
#include "runtime/component.hpp"

namespace tocsin {

/// One thread that ticks components when they are due. A component whose tick throws is reported
/// and never ticked again; its neighbours go on.
///
/// What a component hands to a neighbour on the same thread needs no system call: the runner looks
/// at its components' inputs before it sleeps.
class Runner {
 public:
  /// `name` becomes the thread's name, cut to 15 characters. `on_failure` is called from the thread
  /// after a component threw.
  Runner(std::string name, Bus& bus, std::function<void()> on_failure = {});
  /// Waits for the running tick.
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Any thread. The component is ticked once at once, after `start`; it and its account must live
  /// until it is removed.
  void add(Component& component, TickAccount& account);
  /// Any thread but this runner's. False when a tick did not end within `patience`: the component
  /// is still there then.
  [[nodiscard]] bool remove(Component& component, Duration patience);
  void start();

 private:
  struct Entry {
    Component* component;
    TickAccount* account;
    bool started = false;
    bool failed = false;
  };
  void run();
  void take_changes();
  /// True when one was due.
  bool tick_due();
  void tick(Entry& entry);
  void fail(Entry& entry, const std::string& error);
  void sleep();
  void look_at_descriptors();
  [[nodiscard]] bool is_due(const Entry& entry) const;
  [[nodiscard]] bool has_work() const;
  [[nodiscard]] bool descriptor_ready(const Schedule& schedule) const;
  void collect_descriptors();

  const std::string name_;
  Bus& bus_;
  const std::function<void()> on_failure_;
  std::vector<Entry> entries_;
  std::vector<int> descriptors_;
  Sleeper sleeper_;
  Time now_{};
  int rounds_awake_ = 0;
  std::atomic<bool> stopping_{false};

  std::mutex changes_mutex_;
  std::condition_variable changed_;
  std::atomic<bool> has_changes_{false};
  std::vector<Entry> to_add_;
  const Component* to_remove_ = nullptr;
  std::thread thread_;
};

}  // namespace tocsin
