// SPDX-License-Identifier: Apache-2.0
#include "scheduler.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tocsin::simulation {
namespace {

constexpr int most_rounds = 10'000;

}  // namespace

void Scheduler::add(Component& component, std::function<bool()> running) {
  entries_.push_back({&component, std::move(running)});
}

Time Scheduler::next() const {
  Time next = never;
  for (const Entry& entry : entries_) {
    if (!entry.failed) next = std::min(next, entry.component->schedule().due());
  }
  return next;
}

bool Scheduler::due(Entry& entry, Time now) {
  const Schedule& schedule = entry.component->schedule();
  const bool wanted = !entry.started || schedule.input_pending || schedule.due() <= now;
  return wanted && !entry.failed;
}

void Scheduler::run(Time now) {
  bool ticked = true;
  for (int round = 0; ticked; ++round) {
    ticked = false;
    for (Entry& entry : entries_) {
      if (!due(entry, now)) continue;
      if (round == most_rounds) {
        throw std::runtime_error(entry.component->name() + " never comes to rest at one instant");
      }
      tick(entry, now);
      ticked = true;
    }
  }
}

void Scheduler::tick(Entry& entry, Time now) {
  if (!entry.running()) {
    entry.failed = true;
    return;
  }
  ++ticks_;
  entry.started = true;
  entry.component->schedule().begin_tick(now);
  try {
    entry.component->tick(now);
  } catch (const std::exception& error) {
    entry.failed = true;
    if (on_failure_) on_failure_(entry.component->name(), error.what(), now);
    Logger(entry.component->name()).error("failed and is ticked no more: {}", error.what());
  }
}

}  // namespace tocsin::simulation
