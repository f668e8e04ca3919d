// SPDX-License-Identifier: Apache-2.0
#include "background_thread.hpp"

#include <utility>

namespace tocsin {
namespace {

class AtOnce final : public Background {
  void post(std::function<void()> work) override { work(); }
  [[nodiscard]] std::size_t waiting() const override { return 0; }
};

}  // namespace

std::unique_ptr<Background> work_at_once() { return std::make_unique<AtOnce>(); }

BackgroundThread::~BackgroundThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void BackgroundThread::post(std::function<void()> work) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_.push_back(std::move(work));
  }
  changed_.notify_one();
}

std::size_t BackgroundThread::waiting() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return work_.size();
}

void BackgroundThread::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ends_ || !work_.empty(); });
    if (work_.empty()) return;
    const std::function<void()> next = std::move(work_.front());
    lock.unlock();
    next();
    lock.lock();
    work_.pop_front();
  }
}

}  // namespace tocsin
