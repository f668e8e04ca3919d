// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// Which flows of peers somebody on this host reads, of those that cross on demand. Thread-safe.
class Demand {
 public:
  /// One reader more, or one less.
  void count(FlowId flow, bool there) {
    const std::lock_guard<std::mutex> lock(mutex_);
    readers_[flow] += there ? 1 : -1;
    changed_.insert(flow);
  }
  /// Whether it was counted.
  bool forget(FlowId flow) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changed_.erase(flow);
    return readers_.erase(flow) != 0;
  }
  /// Flows whose readers have changed since the last call, and whether there are any.
  [[nodiscard]] std::vector<std::pair<FlowId, bool>> take_changed() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::pair<FlowId, bool>> changed;
    changed.reserve(changed_.size());
    for (const FlowId flow : changed_) changed.emplace_back(flow, readers_[flow] > 0);
    changed_.clear();
    return changed;
  }

 private:
  std::mutex mutex_;
  std::map<FlowId, int> readers_;
  std::set<FlowId> changed_;
};

}  // namespace tocsin
