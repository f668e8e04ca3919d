// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "link_router/link_acknowledgement.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// One instance of a peer, as the sender counts them.
using PeerIndex = std::uint32_t;

/// A sample that was put on the wire, until its fate is known.
struct SentSample {
  enum class Fate : std::uint8_t { open, delivered, lost, unwanted };
  StreamId stream = 0;
  TrafficClass traffic_class = TrafficClass::low;
  Sample sample;  ///< as it is sent
  Sample plain;   ///< as it was offered
  WireCost cost;
  Time offered{};
  Time expires = never;  ///< not repaired after it
  WhilePaused while_paused = WhilePaused::send;
  bool is_repaired = false;        ///< by the rule of its stream
  bool is_stored = false;          ///< its fate is published
  std::vector<PeerIndex> missing;  ///< peers that want it and have not acknowledged it
  unsigned transmissions = 0;
  PathIndex path = 0;      ///< of the last transmission
  unsigned under_way = 0;  ///< transmissions times peers of which nothing is known
  Time first_sent{};
  Time repair_at = never;
  std::size_t newer = 0;    ///< of its source that were sent since
  bool superseded = false;  ///< as many newer ones as its stream keeps were sent
  bool late = false;
  bool repaired = false;
  bool received = false;  ///< to a peer at least
  bool counted = true;    ///< false: sent before already, this is for a peer that was late
  Fate fate = Fate::open;

  SamplePiece piece{};                ///< of the sample, which `cost` is for
  std::shared_ptr<SentSample> whole;  ///< what became of all pieces; null: this is no piece
  std::uint64_t burst = 0;            ///< pieces that were first sent together
  WireCost burst_cost;                ///< of those of the burst up to this one
  unsigned open_pieces = 0;           ///< of a whole: whose fate is open
  unsigned lost_pieces = 0;           ///< of a whole
  unsigned received_pieces = 0;       ///< of a whole
  bool arrives = false;               ///< of a whole: a piece was received

  /// Sent again when it is known to be lost, at the pace of bulk; else when no acknowledgement has
  /// named it for a while.
  [[nodiscard]] bool mends_with_bulk() const { return whole != nullptr || !is_repaired; }
};
using SentSamplePtr = std::shared_ptr<SentSample>;

/// What a transmission became for one peer.
struct Settlement {
  PeerIndex peer = 0;
  PathIndex path = 0;
  bool received = false;
  WireCost cost;
  std::uint64_t burst = 0;
  std::uint64_t order = 0;
  Time sent{};
  Time expected{};
  Time arrived{};         ///< by the peer's clock
  bool is_exact = false;  ///< else it arrived then or before
  SentSamplePtr sample;
};

/// The transmissions of all streams, and which peers have them.
///
/// A transmission is given up for a peer when a later one of its class and path was received there
/// (the radio's queues are first in, first out) or when no acknowledgement names it for long; what
/// mends_with_bulk() also when one that was made after its arrival was due does not name it. An
/// acknowledgement that names it later still counts. Pure; `now` never decreases.
class DeliveryLog {
 public:
  /// `patience` beyond the expected arrival a transmission is given up.
  explicit DeliveryLog(Duration patience) : patience_(patience) {}
  void set_patience(Duration patience) { patience_ = patience; }

  struct Copy {
    PeerIndex peer = 0;
    Time expected{};  ///< when it should have left the radio
    bool settled = false;
    bool received = false;
  };
  struct Record {
    TransmissionNumber number = 0;
    PathIndex path = 0;
    Time sent{};
    WireCost cost;            ///< of a piece in a burst, with those before it
    std::uint64_t burst = 0;  ///< 0: it was sent alone
    SentSamplePtr sample;
    std::vector<Copy> copies;
    std::uint64_t order = 0;  ///< given by add()
  };
  /// Numbers of a stream rise, on each path.
  void add(Record record);
  void forget_stream(StreamId stream);
  /// Nothing is expected of it any more.
  [[nodiscard]] std::vector<Settlement> forget_peer(PeerIndex peer);

  [[nodiscard]] std::vector<Settlement> on_acknowledgement(
      PeerIndex peer, const LinkAcknowledgement& acknowledgement);
  [[nodiscard]] std::vector<Settlement> give_up_overdue(Time now);
  /// When give_up_overdue() has something; `never` when nothing is under way.
  [[nodiscard]] Time next_overdue() const;
  /// Whether anything is under way to the peer by the path.
  [[nodiscard]] bool is_under_way(PeerIndex peer, PathIndex path) const;
  /// Samples of at least so many packets that the peer has not acknowledged yet; of pieces the last
  /// one counts. One that goes whole does not count, since its loss is not known for long.
  [[nodiscard]] std::size_t count_under_way(PeerIndex peer, PathIndex path,
                                            std::size_t packets) const;

 private:
  using RecordPtr = std::shared_ptr<Record>;
  using Records = std::deque<RecordPtr>;
  /// The highest number of a stream that a peer has named.
  struct Highest {
    TransmissionNumber number = 0;
    Time expected{};  ///< as in Copy
  };
  void take_stream(PeerIndex peer, const StreamAcknowledgement& acknowledgement, Time made,
                   std::vector<Settlement>& settled);
  /// What lies behind the highest number and should have arrived before the acknowledgement was
  /// made.
  void give_up_tail(PeerIndex peer, const StreamAcknowledgement& acknowledgement,
                    std::vector<Settlement>& lost);
  void give_up_overtaken(PeerIndex peer, const std::vector<Settlement>& received,
                         std::vector<Settlement>& settled);
  /// Copies of those under way for which `ends` is true are given up.
  template <class Ends>
  void give_up(Ends ends, std::vector<Settlement>& settled);
  static Settlement settle(Record& record, Copy& copy, bool received);
  [[nodiscard]] Settlement receive(Record& record, Copy& copy,
                                   const StreamAcknowledgement& acknowledgement, Time made);
  void drop_settled();

  Duration patience_;
  std::uint64_t last_order_ = 0;
  /// A stream on a path.
  using Way = std::pair<StreamId, PathIndex>;
  std::map<Way, Records> streams_;
  std::map<std::pair<Way, PeerIndex>, Highest> highest_;
  std::vector<RecordPtr> under_way_;  ///< those with copies that are not settled, by time
};

}  // namespace tocsin::router
