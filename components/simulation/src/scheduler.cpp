// SPDX-License-Identifier: Apache-2.0
#include "scheduler.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tocsin::simulation {
namespace {

constexpr int most_rounds = 10'000;

}  // namespace

void Scheduler::add(Component& component, std::function<bool()> running, Time first) {
  entries_.push_back({&component, &component.schedule(), std::move(running), first});
  next_ = Time::min();
}

void Scheduler::remove(const Component& component) {
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                [&](const Entry& one) { return one.component == &component; }),
                 entries_.end());
}

void Scheduler::run(Time now) {
  for (int round = 0; run_round(now, round); ++round) {
  }
}

/// False when nobody was due; then the earliest deadline is known.
bool Scheduler::run_round(Time now, int round) {
  bool ticked = false;
  next_ = never;
  for (Entry& entry : entries_) {
    if (entry.failed) continue;
    if (now < entry.first) {
      next_ = std::min(next_, entry.first);
      continue;
    }
    if (entry.started && !entry.schedule->input_pending && entry.schedule->due() > now) {
      next_ = std::min(next_, entry.schedule->due());
      continue;
    }
    if (round == most_rounds) {
      throw std::runtime_error(entry.component->name() + " never comes to rest at one instant");
    }
    tick(entry, now);
    ticked = true;
  }
  return ticked;
}

void Scheduler::tick(Entry& entry, Time now) {
  if (!entry.running()) {
    entry.failed = true;
    return;
  }
  ++ticks_;
  entry.started = true;
  entry.schedule->begin_tick(now);
  try {
    entry.component->tick(now);
  } catch (const std::exception& error) {
    entry.failed = true;
    if (on_failure_) on_failure_(entry.component->name(), error.what(), now);
    Logger(entry.component->name()).error("failed and is ticked no more: {}", error.what());
  }
}

}  // namespace tocsin::simulation
