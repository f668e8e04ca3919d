// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "link_router/delivery_log.hpp"
#include "link_router/link_estimator.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// One instance of a peer as a sender sees it.
struct PeerPath {
  PeerPath(PeerIndex number, InstanceId id) : index(number), instance(id) {}
  PeerIndex index;
  InstanceId instance;
  std::set<StreamId> wanted;  ///< streams that it reads
  LinkEstimator estimator;
};

/// The peers of a sender, by name: what each reads, and what its acknowledgements say of the way to
/// it. A peer that acknowledges nothing is silent and holds the others up in nothing. Pure.
class PeerPaths {
 public:
  /// Null when there is no such peer.
  [[nodiscard]] PeerPath* find(const std::string& peer);
  [[nodiscard]] PeerPath* find(PeerIndex index);
  /// `peer` must be new.
  void add(const std::string& peer, InstanceId instance);
  void remove(const std::string& peer) { paths_.erase(peer); }
  void forget_stream(StreamId stream);
  [[nodiscard]] std::vector<PeerIndex> readers_of(StreamId stream) const;

  [[nodiscard]] bool empty() const { return paths_.empty(); }
  /// There are peers, and none acknowledges anything.
  [[nodiscard]] bool is_silent(Time now) const;
  /// The live peer of the least capacity; of silent ones when all are; null without peers.
  [[nodiscard]] const LinkEstimator* slowest(Time now) const;
  /// [B/s] of the slowest; what the parameters assume without peers.
  [[nodiscard]] double capacity_bytes_per_s(Time now) const;
  /// How long what is sent at `now` would wait in the radio: longest of the live peers.
  [[nodiscard]] Duration backlog(Time now) const;

  [[nodiscard]] std::map<std::string, PeerPath>& all() { return paths_; }
  [[nodiscard]] const std::map<std::string, PeerPath>& all() const { return paths_; }

 private:
  std::map<std::string, PeerPath> paths_;
  PeerIndex last_ = 0;
};

}  // namespace tocsin::router
