// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "link_router/least_age.hpp"
#include "link_router/link_acknowledgement.hpp"
#include "link_router/link_constants.hpp"
#include "link_router/source_memory.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// What was received from the link.
struct Arrived {
  StreamId stream = 0;
  TransmissionNumber number = 0;  ///< of the link writer
  Origin origin;
  SamplePiece piece{};                    ///< of the sample
  std::shared_ptr<const void> content{};  ///< of a piece: the caller's
  SampleCoding coding{};                  ///< of a piece: of what they make
};

/// What to do with it.
enum class Disposition : std::uint8_t {
  deliver,         ///< to the host
  duplicate,       ///< the host has it
  superseded,      ///< the host has newer ones of its source, as many as the stream keeps
  expired,         ///< older than its lifespan
  unknown_stream,  ///< of a peer or stream that is not known
};

/// Which transmissions are delivered to the host, and the acknowledgements for them.
///
/// Each sample is delivered once; of a stream of depth 1, in the order of its source. A stream of
/// another depth delivers a repaired sample late, behind newer ones. What was delivered is
/// remembered by the peer's and the stream's name over the instances of the peer's router, so that
/// a restart repeats nothing. Ages are over the least one seen lately from the peer's host, since
/// clocks differ. Pure; `now` never decreases.
class LinkReceiver {
 public:
  /// A peer, or its next instance: numbers start afresh. The same instance again changes nothing.
  void on_peer(const std::string& peer, InstanceId instance);
  /// It is gone; what was delivered of it is remembered.
  void forget_peer(const std::string& peer);
  /// Something was heard of a peer that is not there, sent at `sent` by its host's clock: when it
  /// comes, the ages of its samples are known. Of at most 64 peers.
  void on_heard(const std::string& peer, Time sent, Time now);
  /// A link writer of a known peer, on a path: one name has one on each. Of the rule, name, depth,
  /// lifespan and traffic_class count.
  void on_stream(const std::string& peer, StreamId stream, const StreamRule& rule,
                 PathIndex path = 0);
  void forget_stream(const std::string& peer, StreamId stream);

  [[nodiscard]] Disposition on_arrived(const std::string& peer, const Arrived& arrived, Time now);
  /// A piece, by whatever path. When all pieces of its sample are there, their contents in order:
  /// then the sample has arrived, with this transmission, and is for on_arrived(). A whole sample
  /// is its own piece. Of a stream, 8 samples are put together at once; then the oldest goes.
  [[nodiscard]] std::optional<std::vector<std::shared_ptr<const void>>> on_piece(
      const std::string& peer, const Arrived& arrived, Time now);

  /// Between two acknowledgements that repairs wait for, see LinkSender::acknowledgement_period().
  void set_acknowledgement_period(Duration period) { period_ = period; }
  /// There is something to report to the peer besides.
  void ask_for_acknowledgement(const std::string& peer, Time now);
  /// An acknowledgement that is due at `now`, the peer that it is for, and by which paths it goes:
  /// those that something came by since the last one, or both.
  struct Addressed {
    std::string peer;
    LinkAcknowledgement acknowledgement;
    std::array<bool, most_paths> paths{};
  };
  [[nodiscard]] std::optional<Addressed> take_acknowledgement(Time now);
  /// When to call take_acknowledgement(); `never` without a peer.
  [[nodiscard]] Time deadline() const;

 private:
  /// A sample of which pieces are missing.
  struct Partial {
    SourceId source = 0;
    std::uint64_t sequence = 0;
    SampleCoding coding;
    std::vector<bool> there;
    std::vector<std::shared_ptr<const void>> pieces;
    Time last{};  ///< arrival of any
  };
  struct Stream {
    StreamRule rule;
    PathIndex path = 0;
    TransmissionNumber highest = 0;  ///< 0: nothing yet
    std::uint64_t before = 0;        ///< as in StreamAcknowledgement
    Time last{};                     ///< arrival of the highest
    Time noted{};                    ///< arrival of any
    /// Highest of the numbers far below that were received since then, and no other.
    std::optional<std::pair<TransmissionNumber, Time>> low;
  };
  using Partials = std::list<Partial>;  ///< the oldest first
  struct Peer {
    std::optional<InstanceId> instance;  ///< empty: it is gone
    std::map<StreamId, Stream> streams;
    std::map<std::string, Partials> partial;                             ///< by name of the stream
    std::map<std::pair<std::string, SourceId>, SourceMemory> delivered;  ///< the same
    std::array<bool, most_paths> came_by{};  ///< since the last acknowledgement
    LeastAge age{clock_window};
    std::uint32_t acknowledgements = 0;
    std::optional<Time> acknowledgement_sent;
    Time acknowledgement_due = Time::min();
  };
  [[nodiscard]] static Partials::iterator partial_of(Partials& all, const Arrived& arrived);
  static void note(Stream& stream, TransmissionNumber number, Time now);
  /// Whether a number far below the highest ends what is remembered of the stream's numbers.
  [[nodiscard]] static bool is_contrary(Stream& stream, TransmissionNumber number, Time now);
  [[nodiscard]] static Disposition judge(Peer& peer, const StreamRule& rule, const Origin& origin,
                                         Time now);
  [[nodiscard]] static SourceMemory& memory_of(Peer& peer, const std::string& stream,
                                               SourceId source);
  /// Not sooner than `period` after the last one.
  static void ask_for_acknowledgement(Peer& peer, Time now, Duration period);
  [[nodiscard]] LinkAcknowledgement make_acknowledgement(Peer& peer, Time now) const;
  [[nodiscard]] static std::array<bool, most_paths> paths_back(Peer& peer);
  /// Whether the peer should hear soon that pieces are still missing.
  [[nodiscard]] static bool misses_pieces(const Peer& peer, Time now);

  std::map<std::string, Peer> peers_;
  Duration period_ = acknowledgement_period;
};

}  // namespace tocsin::router
