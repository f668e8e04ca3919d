// SPDX-License-Identifier: Apache-2.0
#include "runner/runner_threads.hpp"

#include <utility>

namespace tocsin {
namespace {

constexpr Duration patience = std::chrono::seconds(3);

}  // namespace

RunnerThreads::RunnerThreads(Bus& bus, std::function<void()> on_failure)
    : bus_(bus), on_failure_(std::move(on_failure)) {}

void RunnerThreads::add(Component& component, TickAccount& account) {
  runners_.try_emplace(&component, component.name(), bus_, component, account, on_failure_);
}

bool RunnerThreads::remove(Component& component) {
  if (!runners_.at(&component).stop(patience)) return false;
  runners_.erase(&component);
  return true;
}

}  // namespace tocsin
