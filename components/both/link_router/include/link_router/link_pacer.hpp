// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "link_router/delivery_log.hpp"
#include "link_router/link_router_params.hpp"
#include "link_router/linked_peers.hpp"

namespace tocsin::router {

/// When the radio may be given more.
///
/// Bulk goes while the radio's queue is short and little of it is unacknowledged. Small samples of
/// a class that passes the backlog always go, others unless much is outstanding. While no peer
/// answers, one sample each `repair_max_s` may find it alive. Pure; `now` never decreases.
class LinkPacer {
 public:
  /// The references outlive it.
  LinkPacer(const LinkRouterParams& params, const LinkedPeers& peers, const DeliveryLog& log)
      : params_(params), peers_(peers), log_(log) {}

  /// A sample was given to the radio.
  void on_sent(Time now) { sent_at_ = now; }
  /// A sample of the class may go when it makes fewer packets than this.
  [[nodiscard]] std::size_t packets_allowed(TrafficClass traffic_class, Time now) const;
  /// When more may be sent of what waits, unless an acknowledgement is received; `now` or before:
  /// not by time.
  [[nodiscard]] Time opens(Time now) const;
  /// From when repairs may go: `now`, or later while no peer answers.
  [[nodiscard]] Time repairs_open(Time now) const;
  /// Whether the radio is idle, so that backfill may go.
  [[nodiscard]] bool is_idle(Time now) const;
  /// When is_idle() can become true though nothing happens; `never` when it cannot.
  [[nodiscard]] Time idle_from(Time now) const;

 private:
  [[nodiscard]] bool bulk_may_go(Time now) const;
  const LinkRouterParams params_;
  const LinkedPeers& peers_;
  const DeliveryLog& log_;
  Time sent_at_ = Time::min();
};

}  // namespace tocsin::router
