// SPDX-License-Identifier: Apache-2.0
#include "watch/activity.hpp"

#include <mutex>
#include <utility>

namespace tocsin {
namespace {

/// Of the process, as Fast DDS's participants are: who watches them does not make them.
struct Register {
  std::mutex mutex;
  std::vector<std::weak_ptr<const Activity>> activities;
};

Register& watched() {
  static Register instance;
  return instance;
}

}  // namespace

std::shared_ptr<Activity> watched_activity(Duty duty, std::string name, std::uint16_t port) {
  auto activity = std::make_shared<Activity>(duty, std::move(name), port);
  const std::lock_guard<std::mutex> lock(watched().mutex);
  watched().activities.emplace_back(activity);
  return activity;
}

std::vector<std::shared_ptr<const Activity>> watched_activities() {
  std::vector<std::shared_ptr<const Activity>> held;
  std::vector<std::weak_ptr<const Activity>> kept;
  const std::lock_guard<std::mutex> lock(watched().mutex);
  for (const auto& one : watched().activities) {
    auto activity = one.lock();
    if (!activity) continue;
    kept.push_back(one);
    held.push_back(std::move(activity));
  }
  watched().activities = std::move(kept);
  return held;
}

}  // namespace tocsin
