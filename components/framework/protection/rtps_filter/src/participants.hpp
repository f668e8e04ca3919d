// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <unordered_map>
#include <utility>
#include <vector>

#include "announcement_copy.hpp"
#include "discovery.hpp"
#include "rtps_filter/source.hpp"
#include "token_bucket.hpp"
#include "told_numbers.hpp"
#include "unfinished_samples.hpp"

namespace tocsin::rtps_filter {

/// Who has been announced, from where, and what numbers their writers have reached.
class Participants {
 public:
  /// `limits` must outlive it.
  explicit Participants(const Limits& limits) : limits_(limits) {}

  /// Any packet.
  [[nodiscard]] Wrong heard(const Prefix& prefix, Source from, Time now);
  /// What becomes of an announcement of a participant, or of its departure.
  struct Verdict {
    bool hide = false;
    std::int64_t number = 0;     ///< that it is shown with
    std::vector<Octets> before;  ///< messages that are to be shown first
  };
  [[nodiscard]] Checked<Verdict> announced(const Prefix& prefix, const Announcement& what,
                                           Source from, Time now);
  /// The announcement of a known participant is shown so.
  void shown(const Prefix& prefix, AnnouncementCopy copy) { known_[prefix].copy = std::move(copy); }
  /// Whether a departure waits for its confirmation by silence.
  [[nodiscard]] bool waits() const { return waiting_ > 0; }
  /// A packet that is no departure: its participant has not left.
  void stays(const Prefix& prefix, Time now);
  /// See RtpsFilter.
  void supersede(const Prefix& prefix, Time now);
  /// See RtpsFilter.
  [[nodiscard]] std::vector<Octets> take_due() { return std::exchange(due_, {}); }
  void authenticate(const Prefix& prefix);
  void forget(const Prefix& prefix);
  [[nodiscard]] Wrong endpoint(const Prefix& prefix, const Announcement& what);
  /// What becomes of a HEARTBEAT.
  struct Told {
    std::int64_t first;  ///< the number that it may tell: its own, or a step towards it
    bool jumps;          ///< over more than a few numbers
  };
  [[nodiscard]] Checked<Told> heartbeat(const Prefix& prefix, const Heartbeat& heartbeat,
                                        const Addressee& to, Time now);
  /// See RtpsFilter::took.
  void took(Duration cpu, Time now) { jumps_.spend(to_seconds(cpu), limits_.jump_cpu_s, now); }
  [[nodiscard]] Wrong gap(const Prefix& prefix, const Gap& gap, const Addressee& to, Time now);
  /// A fragment of user data.
  [[nodiscard]] Wrong fragment(const Prefix& prefix, const Data& data, Time now);
  [[nodiscard]] bool knows(const Prefix& prefix) const { return known_.count(prefix) > 0; }
  [[nodiscard]] std::size_t size() const { return known_.size(); }

 private:
  struct Hash {
    std::size_t operator()(const Prefix& prefix) const {
      std::uint64_t high = 0;
      std::uint32_t low = 0;
      std::memcpy(&high, prefix.data(), sizeof high);
      std::memcpy(&low, prefix.data() + sizeof high, sizeof low);
      return (high ^ std::uint64_t{low} << 21U) * 0x9e3779b97f4a7c15ULL;
    }
  };
  /// It has left unless something of it is received within `wait`.
  struct Departure {
    Time since;
    Duration wait;
  };
  struct Participant {
    std::vector<Source> sources;  ///< it has announced itself from, the first one first
    Time admitted{};
    Time heard{};
    Duration lease{};
    std::int64_t number = 0;  ///< the highest that was shown of its announcements
    Octets content;           ///< of the last one, as it was sent
    AnnouncementCopy copy;    ///< of the last one, as it was shown
    std::optional<Departure> departure;
    bool authenticated = false;
    std::unordered_map<std::uint32_t, ToldNumbers> endpoints;
    TokenBucket gaps;
  };
  using Known = std::unordered_map<Prefix, Participant, Hash>;
  /// What says that a participant has left if it stays silent for so long.
  [[nodiscard]] Octets expect_departure(Participant& participant, Duration wait, Time now);
  [[nodiscard]] Checked<Verdict> leaves(Known::iterator at, Source from, Time now);
  [[nodiscard]] Checked<Verdict> admit(const Prefix& prefix, const Announcement& what, Source from,
                                       Time now);
  /// Takes an announcement of a known participant.
  [[nodiscard]] Verdict renew(Known::iterator at, const Announcement& what, Time now);
  /// Whether there is room for one more; `verdict` gets the departure of who yields.
  [[nodiscard]] bool make_room(Time now, Verdict& verdict);
  Known::iterator longest_silent();
  [[nodiscard]] bool is_full() const;
  /// Whether a participant has announced itself from that socket.
  [[nodiscard]] bool is_known(const Participant& participant, Source from) const;
  /// Whether a participant announces itself from there; at first it may have several sockets.
  [[nodiscard]] bool is_source(Participant& participant, Source from, Time now) const;
  [[nodiscard]] bool is_over(const Participant& participant, Time now) const;
  Known::iterator erase(Known::iterator at);
  /// What is known of a writer's readers; null where nothing is: of a writer that is not announced,
  /// and of those of discovery, whose readers begin anew with their participant.
  ToldNumbers* told_by(const Prefix& prefix, std::uint32_t writer);

  const Limits& limits_;
  Known known_;
  std::size_t endpoints_ = 0;
  std::size_t waiting_ = 0;
  std::vector<Octets> due_;
  TokenBucket jumps_;
  TokenBucket kept_;
  UnfinishedSamples unfinished_;
};

}  // namespace tocsin::rtps_filter
