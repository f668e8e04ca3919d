// SPDX-License-Identifier: Apache-2.0
#include "runner/runner.hpp"

#include <pthread.h>
#include <sys/prctl.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "runner/tick_time.hpp"

namespace tocsin {

Runner::Runner(std::string name, Bus& bus, std::function<void()> on_failure)
    : name_(std::move(name)), bus_(bus), on_failure_(std::move(on_failure)) {}

Runner::~Runner() {
  stopping_ = true;
  sleeper_.wake();
  if (thread_.joinable()) thread_.join();
  take_changes();
  for (const Entry& entry : entries_) entry.component->schedule().set_waker(nullptr);
}

void Runner::add(Component& component, TickAccount& account) {
  component.schedule().set_waker(&sleeper_);
  {
    const std::lock_guard<std::mutex> lock(changes_mutex_);
    to_add_.push_back({&component, &account});
    has_changes_ = true;
  }
  sleeper_.wake();
}

bool Runner::remove(Component& component, Duration patience) {
  std::unique_lock<std::mutex> lock(changes_mutex_);
  to_remove_ = &component;
  has_changes_ = true;
  sleeper_.wake();
  const bool running = thread_.joinable();
  if (!running) {
    lock.unlock();
    take_changes();
    lock.lock();
  }
  const bool removed = changed_.wait_for(lock, patience, [this] { return to_remove_ == nullptr; });
  to_remove_ = nullptr;
  if (removed) component.schedule().set_waker(nullptr);
  return removed;
}

void Runner::start() {
  thread_ = std::thread([this] { run(); });
  pthread_setname_np(thread_.native_handle(), name_.substr(0, 15).c_str());
}

void Runner::run() {
  prctl(PR_SET_TIMERSLACK, 1UL);  // the default adds up to 50 us to every deadline
  sleeper_.claim_this_thread();
  now_ = bus_.now();
  while (!stopping_) {
    if (has_changes_) take_changes();
    const bool ticked = tick_due();
    sleeper_.forget_readable();
    if (!ticked) {
      sleep();
      now_ = bus_.now();
    } else if (++rounds_awake_ == 16) {
      look_at_descriptors();
    }
  }
}

void Runner::take_changes() {
  const std::lock_guard<std::mutex> lock(changes_mutex_);
  has_changes_ = false;
  entries_.insert(entries_.end(), to_add_.begin(), to_add_.end());
  to_add_.clear();
  if (to_remove_ == nullptr) return;
  const auto is_it = [this](const Entry& entry) { return entry.component == to_remove_; };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_it), entries_.end());
  to_remove_ = nullptr;
  changed_.notify_all();
}

bool Runner::tick_due() {
  bool ticked = false;
  for (Entry& entry : entries_) {
    if (!is_due(entry)) continue;
    if (stopping_) return true;
    tick(entry);
    ticked = true;
  }
  return ticked;
}

bool Runner::is_due(const Entry& entry) const {
  if (entry.failed) return false;
  const Schedule& schedule = entry.component->schedule();
  return !entry.started || schedule.has_input() || schedule.due() <= now_ ||
         descriptor_ready(schedule);
}

bool Runner::descriptor_ready(const Schedule& schedule) const {
  const auto& readable = sleeper_.readable();
  const auto& watched = schedule.descriptors;
  return !readable.empty() && std::find_first_of(readable.begin(), readable.end(), watched.begin(),
                                                 watched.end()) != readable.end();
}

void Runner::tick(Entry& entry) {
  entry.started = true;
  const Time began = now_;
  entry.account->begin(began);
  entry.component->schedule().begin_tick(began);
  try {
    const TickTime time(began);
    entry.component->take_changes();
    entry.component->tick(began);
  } catch (const std::exception& thrown) {
    return fail(entry, thrown.what());
  } catch (...) {
    return fail(entry, "something that is no std::exception");
  }
  now_ = bus_.now();
  entry.account->end(began, now_);
}

void Runner::fail(Entry& entry, const std::string& error) {
  now_ = bus_.now();
  entry.failed = true;
  Logger(entry.component->name()).error("failed and is ticked no more: {}", error);
  entry.account->fail(error);
  if (on_failure_) on_failure_();
}

bool Runner::has_work() const {
  const auto pending = [](const Entry& entry) {
    return !entry.failed && entry.component->schedule().has_input();
  };
  return stopping_ || has_changes_ || std::any_of(entries_.begin(), entries_.end(), pending);
}

void Runner::sleep() {
  rounds_awake_ = 0;
  Time due = never;
  for (const Entry& entry : entries_) {
    if (!entry.failed) due = std::min(due, entry.component->schedule().due());
  }
  collect_descriptors();
  sleeper_.announce();
  if (!has_work()) sleeper_.sleep(due, descriptors_);
}

/// So that components that keep each other busy do not keep the others from theirs.
void Runner::look_at_descriptors() {
  rounds_awake_ = 0;
  collect_descriptors();
  if (!descriptors_.empty()) sleeper_.look(descriptors_);
}

void Runner::collect_descriptors() {
  descriptors_.clear();
  for (const Entry& entry : entries_) {
    if (entry.failed) continue;
    const auto& own = entry.component->schedule().descriptors;
    descriptors_.insert(descriptors_.end(), own.begin(), own.end());
  }
}

}  // namespace tocsin
