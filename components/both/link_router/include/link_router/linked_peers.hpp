// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "link_router/delivery_log.hpp"
#include "link_router/link_estimator.hpp"
#include "link_router/path_choice.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// One instance of a peer as a sender sees it.
struct LinkedPeer {
  LinkedPeer(PeerIndex number, InstanceId id)
      : index(number), instance(id), estimators{LinkEstimator(phase_of(id)), LinkEstimator()} {}
  /// [0, 1) Two routers do not have the same.
  [[nodiscard]] static double phase_of(InstanceId id) {
    return static_cast<double>(id % 997) / 997;
  }
  PeerIndex index;
  InstanceId instance;
  std::set<StreamId> wanted;                         ///< streams that it reads
  std::array<LinkEstimator, most_paths> estimators;  ///< of each path to it
};

/// The peers of a sender, by name: what each reads, and what its acknowledgements say of the paths
/// to it. A peer that acknowledges nothing is silent and holds the others up in nothing. Where
/// there are two paths, what no path is named for is of the chosen one. Pure.
class LinkedPeers {
 public:
  /// Null when there is no such peer.
  [[nodiscard]] LinkedPeer* find(const std::string& peer);
  [[nodiscard]] LinkedPeer* find(PeerIndex index);
  /// `peer` must be new.
  void add(const std::string& peer, InstanceId instance);
  void remove(const std::string& peer) { peers_.erase(peer); }
  void forget_stream(StreamId stream);
  [[nodiscard]] std::vector<PeerIndex> readers_of(StreamId stream) const;

  /// There is a second path from now on, which carries at most so much; 0: what it can.
  void add_path(double most_bytes_per_s);
  /// (0, 1] of the air of the first path for what waits for the radio; empty: all of it.
  void set_airtime_share(std::optional<double> share);
  /// [1] that share the air of the first path, ours included; 1 or less: nobody else.
  void set_vehicles(unsigned vehicles) { vehicles_ = std::clamp(vehicles, 1U, most_vehicles); }
  [[nodiscard]] unsigned vehicles() const { return vehicles_; }
  /// This process was frozen until `now`.
  void on_frozen(Time now);
  [[nodiscard]] bool has_two_paths() const { return second_bytes_per_s_.has_value(); }
  /// Chooses between two paths by what they are at `now`. Whether it is another one than before.
  bool choose_path(Time now);
  /// By which what is sent for the first time goes.
  [[nodiscard]] PathIndex path() const { return choice_.chosen(); }
  /// What is known of a path: of the worst live peer.
  [[nodiscard]] PathHealth health(PathIndex path, Time now) const;

  [[nodiscard]] bool empty() const { return peers_.empty(); }
  /// There are peers, and none acknowledges anything.
  [[nodiscard]] bool is_silent(Time now) const { return is_silent(path(), now); }
  [[nodiscard]] bool is_silent(PathIndex path, Time now, Duration after = silent_after) const;
  /// The peer acknowledges nothing that is sent by any path.
  [[nodiscard]] bool is_silent(const LinkedPeer& peer, Time now) const;
  /// The live peer of the least capacity; of silent ones when all are; null without peers.
  [[nodiscard]] const LinkEstimator* slowest(Time now) const { return slowest(path(), now); }
  [[nodiscard]] const LinkEstimator* slowest(PathIndex path, Time now) const;
  /// [B/s] of the slowest; what the parameters assume without peers.
  [[nodiscard]] double capacity_bytes_per_s(Time now) const {
    return capacity_bytes_per_s(path(), now);
  }
  [[nodiscard]] double capacity_bytes_per_s(PathIndex path, Time now) const;
  /// What waits for the radio waits for the share of the air, too.
  [[nodiscard]] bool waits_for_share(Time now) const;
  /// [B/s] of the first path while nobody else sends, of the slowest.
  [[nodiscard]] double free_bytes_per_s(Time now) const;
  /// [B/s] that the share of the air carries, of the slowest, while the first path is chosen;
  /// infinite without a share.
  [[nodiscard]] double share_bytes_per_s(Time now) const;
  /// What small samples must reckon with by the first path while others share its air, and until
  /// they are acknowledged: longest of all peers. Zero where nobody shares it.
  [[nodiscard]] Duration shared_delay() const { return shared(&LinkEstimator::expected_delay); }
  [[nodiscard]] Duration shared_answer() const { return shared(&LinkEstimator::expected_answer); }
  /// How long what is sent at `now` would wait in the radio, or for its share of the air: longest
  /// of the live peers.
  [[nodiscard]] Duration backlog(Time now) const { return backlog(path(), now); }
  [[nodiscard]] Duration backlog(PathIndex path, Time now) const;

  [[nodiscard]] std::map<std::string, LinkedPeer>& all() { return peers_; }
  [[nodiscard]] const std::map<std::string, LinkedPeer>& all() const { return peers_; }

 private:
  [[nodiscard]] Duration shared(Duration (LinkEstimator::*get)() const) const;
  void limit(LinkedPeer& peer) const;
  std::map<std::string, LinkedPeer> peers_;
  PeerIndex last_ = 0;
  std::optional<double> second_bytes_per_s_;  ///< empty: there is one path
  std::optional<double> airtime_share_;
  unsigned vehicles_ = 1;
  PathChoice choice_;
};

}  // namespace tocsin::router
