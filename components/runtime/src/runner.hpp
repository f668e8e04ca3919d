// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "runtime/component.hpp"

namespace tocsin {

/// One thread that ticks components when they are due. A component whose tick throws is reported
/// and never ticked again; its neighbours go on.
class Runner {
 public:
  /// `name` becomes the thread's name, cut to 15 characters.
  Runner(std::string name, Bus& bus);
  /// Stops and joins.
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Before start only. The component must outlive the runner.
  void add(Component& component);
  void start();

 private:
  struct Entry {
    Component* component;
    bool failed = false;
  };
  void run();
  void wait_until_due();
  void tick_due();
  void tick(Entry& entry, Time now);
  void wake() const;
  [[nodiscard]] bool descriptor_ready(const Component& component) const;

  std::string name_;
  Bus& bus_;
  std::vector<Entry> entries_;
  std::vector<int> ready_;
  int wake_fd_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace tocsin
