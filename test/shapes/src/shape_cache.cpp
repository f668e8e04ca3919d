// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape_cache.hpp"

namespace tocsin::shapes {

void ShapeCache::add(const Sample& sample, Duration lifespan) {
  std::deque<Entry>& entries = instances_[sample.instance];
  const Time expires = lifespan == Duration::max() ? Time::max() : sample.received + lifespan;
  entries.push_back({sample, expires});
  if (qos_.keeps_all()) return;
  while (entries.size() > static_cast<std::size_t>(qos_.depth)) entries.pop_front();
}

std::vector<Sample> ShapeCache::read(Time now) const {
  std::vector<Sample> found;
  for (const auto& instance : instances_) {
    for (const Entry& entry : instance.second) {
      if (now < entry.expires) found.push_back(entry.sample);
    }
  }
  return found;
}

std::vector<Sample> ShapeCache::take(Time now) {
  std::vector<Sample> found = read(now);
  instances_.clear();
  return found;
}

}  // namespace tocsin::shapes
