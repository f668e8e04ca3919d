// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>

#include "container/instances.hpp"
#include "runtime/middleware/runner.hpp"

namespace tocsin {

/// A thread for each component of a container.
class RunnerThreads : public Ticker {
 public:
  /// `on_failure` is called from a component's thread after it threw.
  RunnerThreads(Bus& bus, std::function<void()> on_failure);

  void add(Component& component, TickAccount& account) override;
  /// Waits up to 3 s for the running tick.
  [[nodiscard]] bool remove(Component& component) override;

 private:
  Bus& bus_;
  const std::function<void()> on_failure_;
  std::map<Component*, Runner> runners_;
};

}  // namespace tocsin
