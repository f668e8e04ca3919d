// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "container/instances.hpp"
#include "runner/runner.hpp"

namespace tocsin {

/// One thread for all components of a container, or one for each.
class RunnerThreads : public Ticker {
 public:
  /// `on_failure` is called from a component's thread after it threw.
  RunnerThreads(Bus& bus, bool shared, const std::string& name, std::function<void()> on_failure);

  void add(Component& component, TickAccount& account) override;
  /// Waits up to 3 s for the running tick.
  [[nodiscard]] bool remove(Component& component) override;

 private:
  std::unique_ptr<Runner> start(const std::string& name);
  Bus& bus_;
  const std::function<void()> on_failure_;
  std::unique_ptr<Runner> shared_;  // null: one each
  std::map<Component*, std::unique_ptr<Runner>> own_;
};

}  // namespace tocsin
