// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <set>

#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Participants on the link that are no routers and read what this one sends: they know nothing of
/// pieces of samples. Thread-safe.
class OutsideReaders {
 public:
  using Participant = eprosima::fastdds::rtps::GuidPrefix_t;

  void on_router(const Participant& participant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    routers_.insert(participant);
    outside_.erase(participant);
  }
  void on_gone(const Participant& participant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    routers_.erase(participant);
    outside_.erase(participant);
  }
  /// It reads a flow.
  void on_reader(const Participant& participant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (routers_.count(participant) == 0) outside_.insert(participant);
  }
  [[nodiscard]] bool any() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !outside_.empty();
  }

 private:
  mutable std::mutex mutex_;
  std::set<Participant> routers_;
  std::set<Participant> outside_;
};

}  // namespace tocsin
