// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_router/delivery_log.hpp"
#include "link_router/link_acknowledgement.hpp"
#include "link_router/link_budget.hpp"
#include "link_router/link_estimator.hpp"
#include "link_router/link_queue.hpp"
#include "link_router/link_router_params.hpp"
#include "link_router/link_state_values.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// Decides what the router puts on the link, and when.
///
/// Order: strictly by class; in a class new samples before repairs; no sample is sent that is older
/// than its lifespan, none again that a newer one of its source has followed. Bulk (a sample of
/// many packets) waits until the radio's queue is short, so that what comes next does not wait
/// behind it. What a peer has not acknowledged is sent again, at growing intervals and within a
/// share of the capacity. Peers are known by name; a new life of one starts afresh.
///
///     sender.offer(stream, sample, now);                         // for each sample of the host
///     while (auto one = sender.next(now)) sender.on_written(write(*one));  // after each call, and
///                                                                          // at deadline()
///     sender.on_acknowledgement("station", acknowledgement, now);
///
/// Pure; `now` never decreases.
class LinkSender {
 public:
  /// Throws ConfigError for parameters that do not fit each other.
  explicit LinkSender(const LinkRouterParams& params);
  LinkSender(const LinkSender&) = delete;
  LinkSender& operator=(const LinkSender&) = delete;

  /// A link writer.
  void add_stream(StreamId stream, const StreamRule& rule);
  void remove_stream(StreamId stream);

  /// A peer, or its next life, which has nothing and wants nothing yet. The same life again changes
  /// nothing.
  void on_peer(const std::string& peer, Incarnation incarnation, Time now);
  void forget_peer(const std::string& peer, Time now);
  /// Whether the peer reads the stream. What nobody wants is put on the wire and not repaired. To
  /// one that begins to, the newest samples of a durable stream are sent.
  void set_wanted(const std::string& peer, StreamId stream, bool wanted, Time now);

  /// A sample of the host for a stream that was added.
  void offer(StreamId stream, const Sample& sample, Time now);
  /// What to put on the wire at `now`, if anything.
  [[nodiscard]] std::optional<Transmission> next(Time now);
  /// The last transmission was written, under this number. One that was not is lost unless it is
  /// repaired.
  void on_written(TransmissionNumber number);
  /// When to call next() though nothing happens; `never` when there is nothing to do.
  [[nodiscard]] Time deadline(Time now) const;

  /// Of the peer's present life; acknowledgements of an unknown peer are ignored.
  void on_acknowledgement(const std::string& peer, const LinkAcknowledgement& acknowledgement,
                          Time now);
  /// What became of samples of stored streams since the last call.
  [[nodiscard]] std::vector<StoredFate> take_fates() { return std::exchange(fates_, {}); }

  /// The stream on which stored samples are backfilled: no class, no repair, nothing is counted.
  void add_backfill_stream(StreamId stream);
  /// Whether one may go at `now`: nothing else waits, the radio's queue is short, and the gate is
  /// open. While no peer answers, one each `repair_max_s` may find it alive.
  [[nodiscard]] bool may_backfill(Time now) const;
  /// When may_backfill() can become true though nothing happens; `never` when it cannot.
  [[nodiscard]] Time backfill_opens(Time now) const;
  /// A sample of that stream goes on the wire at once; on_written() as after next().
  void backfill(StreamId stream, const Sample& sample, Time now);

  /// The gate: streams that are not `send` are silent while it is closed.
  void set_paused(bool paused, Time now);

  /// Of each adaptive stream.
  [[nodiscard]] std::vector<StreamBudget> budgets(Time now) const;
  [[nodiscard]] LinkStateValues state(Time now) const;
  /// [B/s] estimate, of the slowest live peer.
  [[nodiscard]] double capacity_bytes_per_s(Time now) const;
  /// Zeroes when there is no such stream.
  [[nodiscard]] StreamCounts stream_counts(StreamId stream) const;

 private:
  /// What was last offered or sent of one source of a stream.
  struct Source {
    Time sent = Time::min();      ///< the last one that was sent for the first time
    std::optional<Waiting> held;  ///< waits for the end of the pause
    SentSamplePtr newest;         ///< of a durable stream: for peers that come later
  };
  struct Stream {
    StreamRule rule;
    StreamCounts counts;
    std::map<SourceId, Source> sources;
    bool fills_in = false;
    RateMeter nominal;            ///< of an adaptive stream: what it would take at scale 1
    double peak_bytes_per_s = 0;  ///< of nominal, forgotten slowly
    Time offered = Time::min();
  };
  struct Peer {
    Peer(const LinkRouterParams& params, PeerIndex number, Incarnation life)
        : index(number), incarnation(life), estimator(params) {}
    PeerIndex index;
    Incarnation incarnation;
    std::set<StreamId> wanted;
    LinkEstimator estimator;
  };

  [[nodiscard]] bool is_paused(const StreamRule& rule) const;
  [[nodiscard]] ClassCounts& counts(TrafficClass traffic_class) {
    return counts_[index_of(traffic_class)];
  }
  [[nodiscard]] Source& source_of(Stream& stream, const Sample& sample) const;
  void meter_offer(Stream& stream, const WireCost& cost, Time now);
  void enqueue(Stream& stream, const Waiting& waiting);
  void hold(Stream& stream, const Waiting& waiting);
  void count_dropped(const std::vector<Dropped>& dropped);
  void count_dropped(Stream& stream, const Waiting& waiting, DropReason reason);
  void tell_fate(const SentSample& sent, LiveFate fate);
  [[nodiscard]] const LinkEstimator* slowest_peer(Time now) const;

  [[nodiscard]] std::optional<Waiting> take_waiting(TrafficClass traffic_class, Time now);
  [[nodiscard]] std::size_t packets_allowed(TrafficClass traffic_class, Time now) const;
  [[nodiscard]] bool bulk_may_go(Time now) const;
  [[nodiscard]] SentSamplePtr due_repair(TrafficClass traffic_class, Time now);
  [[nodiscard]] bool can_repair(const SentSample& sample, Time now) const;
  [[nodiscard]] bool may_repair(const SentSample& sample, Time now) const;
  [[nodiscard]] Time repair_ready(Time now) const;
  /// When more may be sent of what waits, unless an acknowledgement comes; `now` or before: not by
  /// time.
  [[nodiscard]] Time gate_opens(Time now) const;
  [[nodiscard]] SentSamplePtr make_sent(const Waiting& waiting);
  void supersede(const SentSample& newer, std::size_t depth);
  [[nodiscard]] Transmission transmit(const SentSamplePtr& sent, Time now);
  [[nodiscard]] Duration repair_wait(const SentSample& sent, Duration expected) const;

  void apply(const std::vector<Settlement>& settlements, Time now);
  void apply(const Settlement& settlement, Time now);
  void count_delivered(SentSample& sent);
  void conclude(SentSample& sent);
  void conclude_all(Time now);
  void revive(Time now);
  [[nodiscard]] Peer* peer_of(PeerIndex index);
  [[nodiscard]] bool is_silent(Time now) const;
  [[nodiscard]] Duration backlog(Time now) const;
  void update_scale(Time now);
  [[nodiscard]] double repair_allowance(Time now) const;

  LinkRouterParams params_;
  std::map<StreamId, Stream> streams_;
  std::map<std::string, Peer> peers_;
  PeerIndex last_peer_ = 0;
  LinkQueue queue_;
  DeliveryLog log_;
  DeliveryLog::Record unwritten_;  ///< the last transmission, until it has a number
  std::list<SentSamplePtr> open_;  ///< those whose fate is open, in the order of their sending
  std::array<ClassCounts, traffic_classes.size()> counts_;
  AdaptiveScale scale_;
  RateMeter others_;   ///< on the wire, of streams that do not adapt
  RateMeter repairs_;  ///< on the wire
  Time scale_updated_ = Time::min();
  Time sent_at_ = Time::min();
  double repair_bytes_ = 0;  ///< that may be repaired now: a token bucket
  Time repair_filled_{};
  bool paused_ = false;
  std::vector<StoredFate> fates_;
};

}  // namespace tocsin::router
