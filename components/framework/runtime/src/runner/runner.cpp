// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/runner.hpp"

#include <pthread.h>
#include <sys/prctl.h>

#include <exception>
#include <utility>

#include "runner/sleeper.hpp"
#include "runner/tick_time.hpp"

namespace tocsin {

Runner::Runner(const std::string& name, Bus& bus, Component& component, TickAccount& account,
               std::function<void()> on_failure)
    : bus_(bus),
      component_(component),
      account_(account),
      on_failure_(std::move(on_failure)),
      sleeper_(std::make_unique<Sleeper>()) {
  component_.schedule().set_waker(sleeper_.get());
  thread_ = std::thread([this] { run(); });
  pthread_setname_np(thread_.native_handle(), name.substr(0, 15).c_str());
}

Runner::~Runner() {
  stopping_ = true;
  sleeper_->wake();
  thread_.join();
  component_.schedule().set_waker(nullptr);
}

bool Runner::stop(Duration patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  stopping_ = true;
  sleeper_->wake();
  stopping_ = stopped_.wait_for(lock, patience, [this] { return has_ended_; });
  return stopping_;
}

void Runner::run() {
  prctl(PR_SET_TIMERSLACK, 1UL);  // the default adds up to 50 us to every deadline
  now_ = bus_.now();
  while (!stopping_ || !ended()) run_once();
}

/// Whoever wanted this thread to stop may have lost patience in the meantime.
bool Runner::ended() {
  const std::lock_guard<std::mutex> lock(mutex_);
  has_ended_ = stopping_;
  stopped_.notify_all();
  return has_ended_;
}

void Runner::run_once() {
  const Schedule& schedule = component_.schedule();
  if (!failed_ && (due_ || schedule.input_pending || schedule.due() <= now_)) {
    due_ = false;
    return tick();
  }
  sleep();
  now_ = bus_.now();
}

void Runner::tick() {
  const Time began = now_;
  account_.begin(began);
  component_.schedule().begin_tick(began);
  try {
    const TickTime time(began);
    component_.take_changes();
    component_.tick(began);
  } catch (const std::exception& thrown) {
    return fail(thrown.what());
  } catch (...) {
    return fail("something that is no std::exception");
  }
  now_ = bus_.now();
  account_.end(began, now_);
}

void Runner::fail(const std::string& error) {
  failed_ = true;
  Logger(component_.name()).error("failed and is ticked no more: {}", error);
  account_.fail(error);
  if (on_failure_) on_failure_();
}

void Runner::sleep() {
  const Schedule& schedule = component_.schedule();
  sleeper_->announce();
  if (stopping_) return;
  if (failed_) {
    sleeper_->sleep(never, {});
  } else if (!schedule.input_pending) {
    due_ = sleeper_->sleep(schedule.due(), schedule.descriptors);
  }
}

}  // namespace tocsin
