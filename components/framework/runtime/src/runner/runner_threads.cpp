// SPDX-License-Identifier: Apache-2.0
#include "runner/runner_threads.hpp"

#include <utility>

namespace tocsin {
namespace {

constexpr Duration patience = std::chrono::seconds(3);

}  // namespace

RunnerThreads::RunnerThreads(Bus& bus, bool shared, const std::string& name,
                             std::function<void()> on_failure)
    : bus_(bus), on_failure_(std::move(on_failure)) {
  if (shared) shared_ = start(name);
}

std::unique_ptr<Runner> RunnerThreads::start(const std::string& name) {
  auto runner = std::make_unique<Runner>(name, bus_, on_failure_);
  runner->start();
  return runner;
}

void RunnerThreads::add(Component& component, TickAccount& account) {
  if (shared_) {
    shared_->add(component, account);
    return;
  }
  auto& own = own_[&component] = start(component.name());
  own->add(component, account);
}

bool RunnerThreads::remove(Component& component) {
  Runner& runner = shared_ ? *shared_ : *own_.at(&component);
  if (!runner.remove(component, patience)) return false;
  own_.erase(&component);
  return true;
}

}  // namespace tocsin
