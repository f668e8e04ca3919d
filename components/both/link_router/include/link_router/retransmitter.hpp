// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <vector>

#include "link_router/delivery_log.hpp"
#include "link_router/link_budget.hpp"
#include "link_router/link_gate.hpp"
#include "link_router/link_pacer.hpp"
#include "link_router/link_router_params.hpp"
#include "link_router/linked_peers.hpp"

namespace tocsin::router {

/// The samples whose fate is open, and when one of them is sent again: at growing intervals, within
/// its lifespan, never when as many newer ones of its source were sent as the stream keeps, and
/// together within a share of the capacity (a token bucket).
///
/// Pieces, and samples of classes that are not repaired, are sent again when they are known to be
/// lost: before newer samples, at the pace of bulk. The latter at most `low_repairs` times, and of
/// a sample in pieces when something has arrived. One newer sample of its source does not end a
/// piece, unless that was delivered. Pure; `now` never decreases.
class Retransmitter {
 public:
  /// The references outlive it.
  Retransmitter(const LinkRouterParams& params, const LinkedPeers& peers, const LinkPacer& pacer,
                const LinkGate& gate)
      : params_(params), peers_(peers), pacer_(pacer), gate_(gate) {}

  /// In the order of their sending.
  void add(const SentSamplePtr& sent) { open_.push_back(sent); }
  /// A newer sample of its source is sent for the first time; its stream keeps `depth`.
  void supersede(const SentSample& newer, std::size_t depth);
  /// A sample was delivered: pieces of older ones that it makes worthless are not wanted any more.
  void end_older(const SentSample& delivered, std::size_t depth);
  /// The peer does not want them any more; of one stream, or of all.
  void forget_reader(PeerIndex peer, std::optional<StreamId> stream);
  /// Ends those of a stream; they are open until conclude(). Returns them.
  std::vector<SentSamplePtr> end_stream(StreamId stream);
  /// The link is back: all that is still wanted is due at once.
  void revive(Time now);
  /// The path that they were sent by is dead, and there is another: the same, whatever their share
  /// of the capacity.
  void revive_elsewhere(Time now);
  /// Takes out those whose fate is decided.
  [[nodiscard]] std::vector<SentSamplePtr> conclude(Time now);

  /// A sample was sent once more; `expected` is its wait in queues.
  void schedule(SentSample& sent, Duration expected, Time now) const;
  /// That was another repair, of so many bytes.
  void spend(std::size_t bytes, Time now);
  /// That was a repair at the pace of bulk.
  void note_with_bulk(std::size_t bytes, Time now) { rate_.add(bytes, now); }
  /// Of the others, the repair of the class that is due first; null when none may go.
  [[nodiscard]] SentSamplePtr due(TrafficClass traffic_class, Time now) const;
  /// The first of the class that is to be sent again when bulk may go; null when there is none.
  [[nodiscard]] SentSamplePtr due_with_bulk(TrafficClass traffic_class, Time now) const;
  /// When due() has something, or due_with_bulk(), or a sample expires; `never` when neither.
  [[nodiscard]] Time deadline(Time now) const;
  /// [0, 1] of the capacity, recently spent on repairs.
  [[nodiscard]] double share(Time now) const;

 private:
  /// It is not sent again after this, so that it arrives within its lifespan.
  [[nodiscard]] Time ends_at(const SentSample& sent) const;
  [[nodiscard]] bool can_repair(const SentSample& sent, Time now) const;
  [[nodiscard]] bool may_repair(const SentSample& sent, Time now) const;
  [[nodiscard]] double allowance(Time now) const;
  [[nodiscard]] double bytes_per_s(Time now) const;
  [[nodiscard]] Time ready(Time now) const;

  const LinkRouterParams params_;
  const LinkedPeers& peers_;
  const LinkPacer& pacer_;
  const LinkGate& gate_;
  std::list<SentSamplePtr> open_;
  RateMeter rate_;    ///< on the wire
  double bytes_ = 0;  ///< that may be repaired at filled_
  Time filled_{};
};

}  // namespace tocsin::router
