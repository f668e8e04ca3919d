// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "link_router/compressed_source.hpp"
#include "link_router/delivery_log.hpp"
#include "link_router/freeze_watch.hpp"
#include "link_router/link_acknowledgement.hpp"
#include "link_router/link_budget.hpp"
#include "link_router/link_counters.hpp"
#include "link_router/link_gate.hpp"
#include "link_router/link_pacer.hpp"
#include "link_router/link_queue.hpp"
#include "link_router/link_router_params.hpp"
#include "link_router/link_state_values.hpp"
#include "link_router/linked_peers.hpp"
#include "link_router/retransmitter.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// What to put on the wire now, by the stream's link writer.
struct Transmission {
  StreamId stream = 0;
  Sample sample;
  SamplePiece piece{};           ///< of the sample
  std::size_t plain_bytes = 0;   ///< of this piece, had the sample not been compressed
  bool repair = false;           ///< it was sent before
  PathIndex path = 0;            ///< by which
  DeliveryLog::Record record{};  ///< for on_written(); without its number
};

/// Decides what the router puts on the link, and when.
///
/// Order: strictly by class; in a class repairs at the pace of bulk, new samples, other repairs; no
/// sample is sent that is older than its lifespan or would be on arrival, none again that a newer
/// one of its source has followed. The queue (LinkQueue), the pause (LinkGate), the pace
/// (LinkPacer), the repairs (Retransmitter), the budgets (LinkAdaptation) and the counters
/// (LinkCounters) are its parts. Peers are known by name; a new instance of one starts afresh.
///
/// Where there are two paths, first transmissions go by the better one (PathChoice). By the rule of
/// the stream, a repair goes by the path that the last transmission did not take, and a copy of the
/// first by the other while the better one is poor. One small sample a second goes by both, so that
/// the other one is known.
///
///     sender.offer(stream, sample, now);      // for each sample of the host
///     while (auto one = sender.next(now)) {   // after each call, and at deadline()
///       sender.on_written(*one, write(*one));
///     }
///     sender.on_acknowledgement("station", acknowledgement, now);
///
/// Pure; `now` never decreases.
class LinkSender {
 public:
  /// Throws ConfigError for parameters that do not fit each other.
  explicit LinkSender(const LinkRouterParams& params);
  LinkSender(const LinkSender&) = delete;
  LinkSender& operator=(const LinkSender&) = delete;

  /// Before all else that happens at `now`.
  void begin(Time now);

  /// A sample that does not fit a packet goes in pieces of at most so many bytes; 0: whole.
  void set_largest_piece(std::size_t bytes) { largest_piece_ = bytes; }

  /// By what samples of compressed streams are made smaller; without it none is. None is either
  /// while samples go whole: somebody reads who knows neither pieces nor compression.
  void set_compress(Compress compress) { compress_ = std::move(compress); }

  /// (0, 1] of the air of the first path, where several share it, for what classes normal and low
  /// send and what is backfilled; small samples do not wait for it. Empty: all of it.
  void set_airtime_share(std::optional<double> share) { peers_.set_airtime_share(share); }
  /// [1] that share the air, ours included. Repairs wait for the acknowledgement that is to be
  /// expected there, and take this part of the capacity's share for repairs: who repeats what has
  /// arrived takes the air in which the acknowledgement would come.
  void set_vehicles(unsigned vehicles) { peers_.set_vehicles(vehicles); }
  /// How far apart acknowledgements are that go the same way: 50 ms, and up to 200 ms where small
  /// samples wait so long for air that others share.
  [[nodiscard]] Duration acknowledgement_period() const;
  /// Whether something has waited for the share since the last call, or was made smaller for it.
  [[nodiscard]] bool take_share_missed() { return std::exchange(share_missed_, false); }
  /// [B/s] that the way carries when nobody else sends.
  [[nodiscard]] double free_bytes_per_s(Time now) const { return peers_.free_bytes_per_s(now); }
  /// [0, 1] of that air, used by them lately: bytes over what the way carries when nobody else
  /// sends, mean of about 2 s.
  [[nodiscard]] double airtime_used(Time now) const {
    return of_share_.bytes_per_s(now) / free_bytes_per_s(now);
  }

  /// There is a second path.
  void add_path() { peers_.add_path(params_.second_bytes_per_s); }

  /// A link writer.
  void add_stream(StreamId stream, const StreamRule& rule);
  void remove_stream(StreamId stream);

  /// A peer, or its next instance, which has nothing and wants nothing yet. The same instance again
  /// changes nothing.
  void on_peer(const std::string& peer, InstanceId instance, Time now);
  void forget_peer(const std::string& peer, Time now);
  /// Whether the peer reads the stream. What nobody wants is put on the wire and not repaired, or,
  /// on demand, not sent at all. To one that begins to, the newest samples of a durable stream are
  /// sent.
  void set_wanted(const std::string& peer, StreamId stream, bool wanted, Time now);

  /// Whether any peer reads it.
  [[nodiscard]] bool is_wanted(StreamId stream) const { return !peers_.readers_of(stream).empty(); }

  /// A sample of the host for a stream that was added.
  void offer(StreamId stream, const Sample& sample, Time now);
  /// What to put on the wire at `now`, if anything.
  [[nodiscard]] std::optional<Transmission> next(Time now);
  /// It was written, under this number, the next of its stream on its path. One that was not is
  /// lost unless it is repaired.
  void on_written(const Transmission& transmission, TransmissionNumber number);
  /// When to call next() though nothing happens; `never` when there is nothing to do.
  [[nodiscard]] Time deadline(Time now) const;

  /// Of the peer's present instance; acknowledgements of an unknown peer are ignored.
  void on_acknowledgement(const std::string& peer, const LinkAcknowledgement& acknowledgement,
                          Time now);
  /// What became of samples of stored streams since the last call.
  [[nodiscard]] std::vector<StoredFate> take_fates() { return counters_.take_fates(); }

  /// The stream on which stored samples are backfilled: no class, no repair, nothing is counted.
  void add_backfill_stream(StreamId stream);
  /// Whether one may go at `now`: nothing else waits, the radio is idle, and no pause. While no
  /// peer answers, one each `repair_max_s` may find it alive.
  [[nodiscard]] bool may_backfill(Time now) const;
  /// When may_backfill() can become true though nothing happens; `never` when it cannot.
  [[nodiscard]] Time backfill_opens(Time now) const;
  /// A sample of that stream goes on the wire at once, in the pieces that it makes. Those of a
  /// sample that is sent once more fill the gaps of the first.
  [[nodiscard]] std::vector<Transmission> backfill(StreamId stream, const Sample& sample, Time now);

  /// Streams that are not `send` are silent while it is paused.
  void set_paused(bool paused, Time now);
  [[nodiscard]] bool is_paused() const { return gate_.is_paused(); }

  /// Of each adaptive stream.
  [[nodiscard]] std::vector<StreamBudget> budgets(Time now) const;
  [[nodiscard]] LinkStateValues state(Time now) const;
  /// [B/s] estimate, of the slowest live peer.
  [[nodiscard]] double capacity_bytes_per_s(Time now) const {
    return peers_.capacity_bytes_per_s(now);
  }
  /// Zeroes when there is no such stream.
  [[nodiscard]] StreamCounts stream_counts(StreamId stream) const {
    return counters_.of_stream(stream);
  }

 private:
  /// What was last sent of one source of a stream.
  struct Source {
    Time sent = Time::min();  ///< the last one that was sent for the first time
    SentSamplePtr newest;     ///< of a durable stream: for peers that are late
    CompressedSource compressed;
  };
  struct Stream {
    StreamRule rule;
    std::map<SourceId, Source> sources;
    bool is_backfill = false;
  };

  [[nodiscard]] bool has_waiting() const;
  void note_share_missed(Time now);
  [[nodiscard]] static Source& source_of(Stream& stream, const Sample& sample);
  void enqueue(const StreamRule& rule, const Waiting& waiting);
  void hold(const StreamRule& rule, const Waiting& waiting);
  void drop(const std::vector<Dropped>& dropped);
  [[nodiscard]] Transmission send_first(const Waiting& waiting, Time now);
  [[nodiscard]] std::optional<Transmission> next_of(TrafficClass traffic_class, Time now);
  [[nodiscard]] bool has_due_with_bulk(Time now) const;
  /// Whether there is time left for it to cross within its lifespan.
  [[nodiscard]] bool can_arrive(const Waiting& waiting, Time now) const;
  [[nodiscard]] SentSamplePtr make_sent(const Waiting& waiting);
  void compress(SentSample& sent);
  void note_base(const SentSample& sent);
  [[nodiscard]] std::vector<SentSamplePtr> pieces_of(const SentSamplePtr& sent) const;
  /// The same, which are sent one after the other, at once.
  [[nodiscard]] std::vector<SentSamplePtr> in_pieces(const SentSamplePtr& sent);
  [[nodiscard]] Transmission transmit(const SentSamplePtr& sent, Time now);
  /// One transmission more, by its path.
  [[nodiscard]] Transmission put(const SentSamplePtr& sent, Time now);
  [[nodiscard]] Transmission put_copy(const SentSamplePtr& sent, Time now);
  [[nodiscard]] bool goes_by_both(const SentSample& sent, Time now) const;
  [[nodiscard]] PathIndex path_of_repair(const SentSample& sent, Time now) const;
  [[nodiscard]] Duration expected_wait(const SentSample& sent, Time now) const;
  /// What is not acknowledged counts as lost when its acknowledgement was to be expected.
  void follow_shared_air();
  void choose_path(Time now);
  /// An acknowledgement says that something arrived by the path.
  void on_arrivals(LinkedPeer& peer, PathIndex path, bool was_silent, Time now);
  [[nodiscard]] PathValues path_values(PathIndex path, Time now) const;
  void apply(const std::vector<Settlement>& settlements, Time now);
  void apply(const Settlement& settlement, Time now);
  static void take_delivery(SentSample& sent, const Settlement& settlement, Duration delay);
  void conclude(Time now);

  const LinkRouterParams params_;
  FreezeWatch watch_;
  std::map<StreamId, Stream> streams_;
  LinkedPeers peers_;
  LinkQueue queue_;
  DeliveryLog log_;
  LinkGate gate_;
  LinkPacer pacer_;
  Retransmitter retransmitter_;
  LinkAdaptation adaptation_;
  RateMeter of_share_;
  bool share_missed_ = false;
  LinkCounters counters_;
  std::size_t largest_piece_ = largest_piece;
  Compress compress_;
  std::deque<SentSamplePtr> burst_;   ///< the pieces of a sample that are still to be sent, at once
  std::deque<SentSamplePtr> copies_;  ///< what then goes by the other path, too
  std::array<Time, most_paths> sent_by_{Time::min(), Time::min()};  ///< the last transmission
  std::uint64_t bursts_ = 0;
};

}  // namespace tocsin::router
