// SPDX-License-Identifier: Apache-2.0
#include "watch/process_watch.hpp"

#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "watch/own_sockets.hpp"
#include "watch/resident_memory.hpp"

namespace tocsin {
namespace {

std::vector<ActivitySight> look_around() {
  const std::set<std::uint16_t> unread = unread_ports();
  std::vector<ActivitySight> seen;
  for (const auto& one : watched_activities()) {
    // Ended is read first: what begins and ends in between must not look unfinished for ever.
    const std::uint64_t ended = one->ended();
    seen.push_back({one.get(), one->duty(), one->name(), one->begun(), ended,
                    one->port() != 0 && unread.count(one->port()) > 0});
  }
  return seen;
}

}  // namespace

ProcessWatch::ProcessWatch(const WatchLimits& limits, std::function<void(const WatchFinding&)> tell)
    : period_(std::min<Duration>(std::chrono::seconds(1), limits.stuck / 4)),
      tell_(std::move(tell)),
      watchdog_(limits),
      thread_([this] { run(); }) {
  pthread_setname_np(thread_.native_handle(), "watchdog");
}

ProcessWatch::~ProcessWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

std::optional<std::string> ProcessWatch::finding() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return finding_;
}

void ProcessWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, period_, [this] { return stopping_; })) {
    lock.unlock();
    const auto found =
        watchdog_.look(clock_.at(std::chrono::steady_clock::now(), processor_waits()),
                       look_around(), resident_bytes());
    if (found && (found->is_final || !finding())) tell_(*found);
    lock.lock();
    finding_ = found ? std::optional(found->text) : std::nullopt;
    if (found && found->is_final) return;
  }
}

void limit_private_memory(std::uint64_t bytes) {
#ifndef TOCSIN_SANITIZED  // a sanitizer reserves terabytes
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, bytes);
  (void)::setrlimit(RLIMIT_DATA, &limit);  // lowering what is ours is always allowed
#else
  (void)bytes;
#endif
}

}  // namespace tocsin
