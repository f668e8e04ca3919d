// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "devices/background.hpp"

namespace tocsin {

/// A thread of its own, which sleeps while there is nothing to do.
class BackgroundThread final : public Background {
 public:
  BackgroundThread() : thread_([this] { run(); }) {}
  ~BackgroundThread() override;
  void post(std::function<void()> work) override;
  [[nodiscard]] std::size_t waiting() const override;

 private:
  void run();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> work_;  ///< the first is being done
  bool ends_ = false;
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace tocsin
