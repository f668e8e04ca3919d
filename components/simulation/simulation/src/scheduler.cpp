// SPDX-License-Identifier: Apache-2.0
#include "scheduler.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tocsin::simulation {
namespace {

constexpr int most_rounds = 10'000;
constexpr std::size_t bits = 64;

}  // namespace

void Scheduler::add(Component& component, std::function<bool()> running, Time first) {
  entries_.push_back(std::make_unique<Entry>(*this, component, std::move(running), first));
  due_.push_back(first);
  component.schedule().set_waker(entries_.back().get());
  number_entries();
}

void Scheduler::remove(const Component& component) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (&entries_[i]->component != &component) continue;
    entries_[i]->component.schedule().set_waker(nullptr);
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
    due_.erase(due_.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  number_entries();
}

/// Those that had input before have it still.
void Scheduler::number_entries() {
  words_.assign((entries_.size() + bits - 1) / bits, 0);
  next_ = never;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i]->index = i;
    if (entries_[i]->component.schedule().input_pending) ask(i);
    next_ = std::min(next_, due_[i]);
  }
}

void Scheduler::ask(std::size_t index) {
  words_[index / bits] |= std::uint64_t{1} << (index % bits);
  asked_ = true;
}

void Scheduler::ask_the_due(Time now) {
  for (std::size_t i = 0; i < due_.size(); ++i) {
    if (due_[i] <= now) ask(i);
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
  next_ = due_.empty() ? never : *std::min_element(due_.begin(), due_.end());
}

/// Who is asked by one that comes after it has its turn in the next round.
void Scheduler::run_round(Time now) {
  asked_ = false;
  for (std::size_t i = 0; i < words_.size(); ++i) {
    std::uint64_t to_come = ~std::uint64_t{0};
    while (const std::uint64_t left = words_[i] & to_come) {
      const int bit = __builtin_ctzll(left);
      to_come = bit == 63 ? 0 : ~std::uint64_t{0} << (bit + 1);
      words_[i] &= ~(std::uint64_t{1} << bit);
      tick(*entries_[i * bits + static_cast<std::size_t>(bit)], now);
    }
  }
  asked_ = std::any_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word != 0; });
}

void Scheduler::tick(Entry& entry, Time now) {
  if (entry.failed || now < entry.first) return;
  Time& due = due_[entry.index];
  due = never;
  if (!entry.running()) {
    entry.failed = true;
    return;
  }
  ++ticks_;
  Schedule& schedule = entry.component.schedule();
  schedule.begin_tick(now);
  try {
    entry.component.tick(now);
    due = schedule.due();
    if (due <= now) ask(entry.index);
  } catch (const std::exception& error) {
    entry.failed = true;
    if (on_failure_) on_failure_(entry.component.name(), error.what(), now);
    Logger(entry.component.name()).error("failed and is ticked no more: {}", error.what());
  }
}

const std::string& Scheduler::first_asked() const {
  for (const auto& entry : entries_) {
    if ((words_[entry->index / bits] >> (entry->index % bits) & 1U) != 0) {
      return entry->component.name();
    }
  }
  return entries_.front()->component.name();
}

}  // namespace tocsin::simulation
