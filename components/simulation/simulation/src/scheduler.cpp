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
  Entry& entry =
      *entries_.emplace_back(std::make_unique<Entry>(*this, component, std::move(running), first));
  component.schedule().set_waker(&entry);
  if (component.schedule().input_pending) ask(entry);
  next_ = earliest();
}

void Scheduler::remove(const Component& component) {
  const auto is_its = [&component](const auto& entry) { return &entry->component == &component; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), is_its);
  if (found == entries_.end()) return;
  (*found)->component.schedule().set_waker(nullptr);
  entries_.erase(found);
  next_ = earliest();
}

void Scheduler::freeze(const Component& component, bool frozen) {
  for (const auto& entry : entries_) {
    if (&entry->component != &component) continue;
    entry->frozen = frozen;
    if (!frozen) ask(*entry);
  }
  next_ = earliest();
}

Time Scheduler::earliest() const {
  Time earliest = never;
  for (const auto& entry : entries_) {
    if (!entry->frozen) earliest = std::min(earliest, entry->due);
  }
  return earliest;
}

void Scheduler::ask(Entry& entry) {
  entry.asked = true;
  asked_ = true;
}

void Scheduler::ask_the_due(Time now) {
  for (const auto& entry : entries_) {
    if (entry->due <= now && !entry->frozen) ask(*entry);
  }
}

void Scheduler::run(Time now) {
  if (next_ <= now) ask_the_due(now);
  if (!asked_) return;
  for (int round = 0; asked_; ++round) {
    if (round == most_rounds) {
      throw std::runtime_error(first_asked() + " never comes to rest at one instant");
    }
    run_round(now);
  }
  next_ = earliest();
}

/// Who is asked by one that comes after it has its turn in the next round.
void Scheduler::run_round(Time now) {
  asked_ = false;
  for (const auto& entry : entries_) {
    if (!entry->asked || entry->frozen) continue;
    entry->asked = false;
    tick(*entry, now);
  }
}

void Scheduler::tick(Entry& entry, Time now) {
  if (entry.failed || now < entry.first) return;
  entry.due = never;
  if (!entry.running()) {
    entry.failed = true;
    return;
  }
  ++ticks_;
  Schedule& schedule = entry.component.schedule();
  schedule.begin_tick(now);
  try {
    entry.component.tick(now);
    entry.due = schedule.due();
    if (entry.due <= now) ask(entry);
  } catch (const std::exception& error) {
    entry.failed = true;
    if (on_failure_) on_failure_(entry.component.name(), error.what(), now);
    Logger(entry.component.name()).error("failed and is ticked no more: {}", error.what());
  }
}

const std::string& Scheduler::first_asked() const {
  for (const auto& entry : entries_) {
    if (entry->asked) return entry->component.name();
  }
  return entries_.front()->component.name();
}

}  // namespace tocsin::simulation
