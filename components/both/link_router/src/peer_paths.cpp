// SPDX-License-Identifier: Apache-2.0
#include "link_router/peer_paths.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "link_router/link_constants.hpp"
namespace tocsin::router {

PeerPath* PeerPaths::find(const std::string& peer) {
  const auto found = paths_.find(peer);
  return found == paths_.end() ? nullptr : &found->second;
}

PeerPath* PeerPaths::find(PeerIndex index) {
  for (auto& entry : paths_) {
    if (entry.second.index == index) return &entry.second;
  }
  return nullptr;
}

void PeerPaths::add(const std::string& peer, InstanceId instance) {
  paths_.emplace(std::piecewise_construct, std::forward_as_tuple(peer),
                 std::forward_as_tuple(++last_, instance));
}

void PeerPaths::forget_stream(StreamId stream) {
  for (auto& entry : paths_) entry.second.wanted.erase(stream);
}

std::vector<PeerIndex> PeerPaths::readers_of(StreamId stream) const {
  std::vector<PeerIndex> readers;
  for (const auto& entry : paths_) {
    if (entry.second.wanted.count(stream) != 0) readers.push_back(entry.second.index);
  }
  return readers;
}

bool PeerPaths::is_silent(Time now) const {
  return !paths_.empty() && std::all_of(paths_.begin(), paths_.end(), [now](const auto& entry) {
    return entry.second.estimator.is_silent(now);
  });
}

const LinkEstimator* PeerPaths::slowest(Time now) const {
  const LinkEstimator* slowest = nullptr;
  const bool silent = is_silent(now);
  for (const auto& entry : paths_) {
    const LinkEstimator& one = entry.second.estimator;
    if (!silent && one.is_silent(now)) continue;
    if (slowest == nullptr || one.capacity_bytes_per_s() < slowest->capacity_bytes_per_s()) {
      slowest = &one;
    }
  }
  return slowest;
}

double PeerPaths::capacity_bytes_per_s(Time now) const {
  const LinkEstimator* const one = slowest(now);
  return one == nullptr ? capacity_start_bytes_per_s : one->capacity_bytes_per_s();
}

Duration PeerPaths::backlog(Time now) const {
  Duration longest{0};
  for (const auto& entry : paths_) {
    const LinkEstimator& estimator = entry.second.estimator;
    if (!estimator.is_silent(now)) longest = std::max(longest, estimator.backlog(now));
  }
  return longest;
}

}  // namespace tocsin::router
