// SPDX-License-Identifier: Apache-2.0
#include "runner.hpp"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>
#include <exception>
#include <utility>

namespace tocsin {
namespace {

timespec until(Time now, Time due) {
  const Duration wait = due <= now ? Duration::zero() : due - now;
  constexpr Duration longest = std::chrono::hours(1);  // tv_sec of `never` would overflow
  const auto ns = std::min(wait, longest).count();
  return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
}

}  // namespace

Runner::Runner(std::string name, Bus& bus)
    : name_(std::move(name)), bus_(bus), wake_fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

Runner::~Runner() {
  stopping_ = true;
  wake();
  if (thread_.joinable()) thread_.join();
  for (Entry& entry : entries_) entry.component->schedule().set_wake(nullptr);
  close(wake_fd_);
}

void Runner::wake() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(wake_fd_, &one, sizeof one);
}

void Runner::add(Component& component) {
  component.schedule().set_wake([this] { wake(); });
  entries_.push_back({&component});
}

void Runner::start() {
  thread_ = std::thread([this] { run(); });
  pthread_setname_np(thread_.native_handle(), name_.substr(0, 15).c_str());
}

void Runner::run() {
  for (Entry& entry : entries_) tick(entry, bus_.now());
  while (!stopping_) {
    wait_until_due();
    tick_due();
  }
}

void Runner::wait_until_due() {
  Time due = never;
  std::vector<pollfd> polled{{wake_fd_, POLLIN, 0}};
  for (const Entry& entry : entries_) {
    if (entry.failed) continue;
    Schedule& schedule = entry.component->schedule();
    due = std::min(due, schedule.due());
    for (const int descriptor : schedule.descriptors) polled.push_back({descriptor, POLLIN, 0});
  }
  const timespec timeout = until(bus_.now(), due);
  ready_.clear();
  if (ppoll(polled.data(), polled.size(), &timeout, nullptr) <= 0) return;
  std::uint64_t count = 0;
  if (polled[0].revents != 0) {
    [[maybe_unused]] const auto drained = read(wake_fd_, &count, sizeof count);
  }
  for (const pollfd& one : polled) {
    if (one.revents != 0) ready_.push_back(one.fd);
  }
}

bool Runner::descriptor_ready(const Component& component) const {
  const auto& watched = const_cast<Component&>(component).schedule().descriptors;
  return std::find_first_of(ready_.begin(), ready_.end(), watched.begin(), watched.end()) !=
         ready_.end();
}

void Runner::tick_due() {
  for (Entry& entry : entries_) {
    if (entry.failed || stopping_) continue;
    const Time now = bus_.now();
    const Schedule& schedule = entry.component->schedule();
    if (schedule.input_pending || schedule.due() <= now || descriptor_ready(*entry.component)) {
      tick(entry, now);
    }
  }
}

void Runner::tick(Entry& entry, Time now) {
  entry.component->schedule().begin_tick(now);
  try {
    entry.component->tick(now);
  } catch (const std::exception& error) {
    entry.failed = true;
    Logger(entry.component->name()).error("failed and is ticked no more: {}", error.what());
  }
}

}  // namespace tocsin
