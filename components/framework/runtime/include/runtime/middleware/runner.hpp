// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "runtime/component.hpp"
#include "runtime/middleware/tick_account.hpp"

namespace tocsin {

class Sleeper;

/// One thread that ticks one component when it is due, first at once. A component whose tick throws
/// is reported and never ticked again.
class Runner {
 public:
  /// `name` becomes the thread's name, cut to 15 characters. `on_failure` is called from the thread
  /// after the component threw. The component and its account must live until the runner is
  /// stopped or destroyed.
  Runner(const std::string& name, Bus& bus, Component& component, TickAccount& account,
         std::function<void()> on_failure = {});
  /// Waits for the running tick.
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Any thread but this runner's. False when a tick did not end within `patience`: the component
  /// is ticked on then.
  [[nodiscard]] bool stop(Duration patience);

 private:
  void run();
  [[nodiscard]] bool ended();
  void run_once();
  void tick();
  void fail(const std::string& error);
  void sleep();

  Bus& bus_;
  Component& component_;
  TickAccount& account_;
  const std::function<void()> on_failure_;
  const std::unique_ptr<Sleeper> sleeper_;
  Time now_{};
  bool due_ = true;  // for another reason than an input or an instant
  bool failed_ = false;

  std::mutex mutex_;
  std::condition_variable stopped_;
  std::atomic<bool> stopping_{false};
  bool has_ended_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace tocsin
