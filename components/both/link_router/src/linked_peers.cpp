// SPDX-License-Identifier: Apache-2.0
#include "link_router/linked_peers.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "link_router/link_constants.hpp"
namespace tocsin::router {

LinkedPeer* LinkedPeers::find(const std::string& peer) {
  const auto found = peers_.find(peer);
  return found == peers_.end() ? nullptr : &found->second;
}

LinkedPeer* LinkedPeers::find(PeerIndex index) {
  for (auto& entry : peers_) {
    if (entry.second.index == index) return &entry.second;
  }
  return nullptr;
}

void LinkedPeers::add(const std::string& peer, InstanceId instance) {
  const auto place = peers_.emplace(std::piecewise_construct, std::forward_as_tuple(peer),
                                    std::forward_as_tuple(++last_, instance));
  limit(place.first->second);
}

void LinkedPeers::forget_stream(StreamId stream) {
  for (auto& entry : peers_) entry.second.wanted.erase(stream);
}

std::vector<PeerIndex> LinkedPeers::readers_of(StreamId stream) const {
  std::vector<PeerIndex> readers;
  for (const auto& entry : peers_) {
    if (entry.second.wanted.count(stream) != 0) readers.push_back(entry.second.index);
  }
  return readers;
}

void LinkedPeers::add_path(double most_bytes_per_s) {
  second_bytes_per_s_ = most_bytes_per_s;
  for (auto& entry : peers_) limit(entry.second);
}

void LinkedPeers::set_airtime_share(std::optional<double> share) {
  airtime_share_ = share;
  for (auto& entry : peers_) limit(entry.second);
}

void LinkedPeers::limit(LinkedPeer& peer) const {
  peer.estimators[0].set_airtime_share(airtime_share_);
  if (second_bytes_per_s_.value_or(0) > 0) peer.estimators[1].set_limit(*second_bytes_per_s_);
}

void LinkedPeers::on_frozen(Time now) {
  for (auto& entry : peers_) {
    for (LinkEstimator& one : entry.second.estimators) one.on_frozen(now);
  }
}

bool LinkedPeers::choose_path(Time now) {
  if (!has_two_paths()) return false;
  const PathIndex before = path();
  choice_.update({health(0, now), health(1, now)}, now);
  return path() != before;
}

PathHealth LinkedPeers::health(PathIndex path, Time now) const {
  PathHealth worst;
  worst.is_silent = is_silent(path, now, path_silent_after);
  for (const auto& entry : peers_) {
    const LinkEstimator& one = entry.second.estimators[path];
    const auto least = one.least_crossing();
    if (!least || (!worst.is_silent && one.is_silent(now))) continue;
    // Both are by the same two clocks, so that their difference is one of the paths.
    const Duration faster =
        entry.second.estimators[other_path(path)].least_crossing().value_or(*least);
    const Duration behind = std::max(*least - faster, Duration::zero());
    worst.is_known = true;
    worst.loss = std::max(worst.loss, one.loss());
    worst.delay = std::max(worst.delay, one.expected_delay() + behind);
  }
  return worst;
}

bool LinkedPeers::is_silent(PathIndex path, Time now, Duration after) const {
  return !peers_.empty() && std::all_of(peers_.begin(), peers_.end(), [&](const auto& entry) {
    return entry.second.estimators[path].is_silent(now, after);
  });
}

bool LinkedPeers::is_silent(const LinkedPeer& peer, Time now) const {
  return peer.estimators[0].is_silent(now) &&
         (!has_two_paths() || peer.estimators[1].is_silent(now));
}

const LinkEstimator* LinkedPeers::slowest(PathIndex path, Time now) const {
  const LinkEstimator* slowest = nullptr;
  const bool silent = is_silent(path, now);
  for (const auto& entry : peers_) {
    const LinkEstimator& one = entry.second.estimators[path];
    if (!silent && one.is_silent(now)) continue;
    if (slowest == nullptr || one.capacity_bytes_per_s() < slowest->capacity_bytes_per_s()) {
      slowest = &one;
    }
  }
  return slowest;
}

double LinkedPeers::capacity_bytes_per_s(PathIndex path, Time now) const {
  const LinkEstimator* const one = slowest(path, now);
  return one == nullptr ? capacity_start_bytes_per_s : one->capacity_bytes_per_s();
}

bool LinkedPeers::waits_for_share(Time now) const {
  return path() == 0 && std::any_of(peers_.begin(), peers_.end(), [now](const auto& entry) {
           return entry.second.estimators[0].waits_for_share(now);
         });
}

double LinkedPeers::free_bytes_per_s(Time now) const {
  const LinkEstimator* const one = slowest(0, now);
  return one == nullptr ? free_start_bytes_per_s : one->free_bytes_per_s();
}

double LinkedPeers::share_bytes_per_s(Time now) const {
  const LinkEstimator* const one = path() == 0 ? slowest(now) : nullptr;
  return one == nullptr ? std::numeric_limits<double>::infinity() : one->share_bytes_per_s();
}

Duration LinkedPeers::shared(Duration (LinkEstimator::*get)() const) const {
  Duration longest{0};
  if (vehicles_ == 1) return longest;
  for (const auto& entry : peers_) longest = std::max(longest, (entry.second.estimators[0].*get)());
  return longest;
}

Duration LinkedPeers::backlog(PathIndex path, Time now) const {
  Duration longest{0};
  for (const auto& entry : peers_) {
    const LinkEstimator& estimator = entry.second.estimators[path];
    if (!estimator.is_silent(now)) longest = std::max(longest, estimator.backlog(now));
  }
  return longest;
}

}  // namespace tocsin::router
