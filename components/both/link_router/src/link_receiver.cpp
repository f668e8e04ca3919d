// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_receiver.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "link_router/link_constants.hpp"
namespace tocsin::router {
namespace {

/// Peers that are heard of: more names are a forger's.
constexpr std::size_t most_heard = 64;
/// Sources of all streams of a peer that are remembered; then the one silent for longest goes.
constexpr std::size_t most_memories = 256;
/// So long after the last piece of a sample its sender is told again what is missing.
constexpr Duration pieces_missed_for = std::chrono::milliseconds(150);
/// Samples of a stream that are put together at once.
constexpr std::size_t most_partial = 8;
/// A stream is in the acknowledgements of this time after something of it was received, so that one
/// of them arrives.
constexpr Duration repeated_for = std::chrono::milliseconds(250);
/// After so long without an acknowledgement all streams are in the next one.
constexpr Duration all_after = std::chrono::milliseconds(500);
/// What is not older than this was sent a moment ago.
constexpr Duration fresh = std::chrono::milliseconds(500);
/// Only numbers far below the highest are received for so long: the highest is none of the peer's.
constexpr Duration contrary_for = std::chrono::milliseconds(500);
/// A packet takes so long over a radio at least, and ages are over the least one: so much may be
/// missing in them.
constexpr Duration least_way = std::chrono::milliseconds(1);

}  // namespace

void LinkReceiver::on_peer(const std::string& peer, InstanceId instance) {
  Peer& known = peers_.try_emplace(peer).first->second;
  if (known.instance == instance) return;
  known.instance = instance;
  known.streams.clear();
  known.partial.clear();
  known.acknowledgements = 0;
  known.acknowledgement_due = Time::min();
}

void LinkReceiver::forget_peer(const std::string& peer) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return;
  known->second.instance.reset();
  known->second.streams.clear();
  known->second.partial.clear();
  known->second.acknowledgement_due = never;
}

void LinkReceiver::on_heard(const std::string& peer, Time sent, Time now) {
  if (peers_.size() >= most_heard && peers_.count(peer) == 0) return;
  const auto [known, is_new] = peers_.try_emplace(peer);
  if (is_new) known->second.acknowledgement_due = never;
  if (!known->second.instance) (void)known->second.age.age(sent, now);
}

void LinkReceiver::on_stream(const std::string& peer, StreamId stream, const StreamRule& rule,
                             PathIndex path) {
  const auto known = peers_.find(peer);
  if (known == peers_.end() || !known->second.instance) return;
  Stream one;
  one.rule = rule;
  one.path = path;
  known->second.streams[stream] = std::move(one);
}

void LinkReceiver::forget_stream(const std::string& peer, StreamId stream) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return;
  auto& streams = known->second.streams;
  const auto found = streams.find(stream);
  if (found == streams.end()) return;
  known->second.partial.erase(found->second.rule.name);
  streams.erase(found);
}

Disposition LinkReceiver::on_arrived(const std::string& peer, const Arrived& arrived, Time now) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return Disposition::unknown_stream;
  Peer& from = known->second;
  const auto found = from.streams.find(arrived.stream);
  if (found == from.streams.end()) return Disposition::unknown_stream;
  const StreamRule& rule = found->second.rule;
  from.came_by[found->second.path] = true;
  ask_for_acknowledgement(from, now, rule.repaired ? period_ : std::max(period_, relaxed_period));
  const Disposition disposition = judge(from, rule, arrived.origin, now);
  const bool in_vain =
      disposition == Disposition::superseded || disposition == Disposition::expired;
  // Of a stored stream it follows in another way, unless an acknowledgement names it.
  if (!rule.stored || !in_vain) note(found->second, arrived.number, now);
  return disposition;
}

LinkReceiver::Partials::iterator LinkReceiver::partial_of(Partials& all, const Arrived& arrived) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const Partial& one) {
    return one.source == arrived.origin.source && one.sequence == arrived.origin.sequence &&
           one.coding == arrived.coding && one.there.size() == arrived.piece.count;
  });
  if (known != all.end()) return known;
  if (all.size() == most_partial) all.pop_front();
  const std::size_t count = arrived.piece.count;
  all.push_back({arrived.origin.source,
                 arrived.origin.sequence,
                 arrived.coding,
                 std::vector<bool>(count),
                 std::vector<std::shared_ptr<const void>>(count),
                 {}});
  return std::prev(all.end());
}

std::optional<std::vector<std::shared_ptr<const void>>> LinkReceiver::on_piece(
    const std::string& peer, const Arrived& arrived, Time now) {
  if (arrived.piece.is_whole()) return std::vector{arrived.content};
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return std::nullopt;
  const auto found = known->second.streams.find(arrived.stream);
  if (found == known->second.streams.end()) return std::nullopt;
  Stream& stream = found->second;
  known->second.came_by[stream.path] = true;
  Partials& partials = known->second.partial[stream.rule.name];
  const auto partial = partial_of(partials, arrived);
  partial->last = now;
  partial->there[arrived.piece.index] = true;
  partial->pieces[arrived.piece.index] = arrived.content;
  if (std::count(partial->there.begin(), partial->there.end(), false) == 0) {
    auto pieces = std::move(partial->pieces);
    partials.erase(partial);
    // The next bulk waits for it.
    if (pieces.size() >= bulk_packets) ask_for_acknowledgement(known->second, now, period_);
    return pieces;
  }
  ask_for_acknowledgement(known->second, now, std::max(period_, relaxed_period));
  note(stream, arrived.number, now);
  return std::nullopt;
}

void LinkReceiver::note(Stream& stream, TransmissionNumber number, Time now) {
  if (number < stream.highest && stream.highest - number > StreamAcknowledgement::window) {
    if (!is_contrary(stream, number, now)) return;
    stream.highest = 0;
  }
  if (number > stream.highest) {
    const TransmissionNumber ahead = number - stream.highest;
    const bool had_one = stream.highest > 0;
    stream.before = ahead < StreamAcknowledgement::window ? stream.before << ahead : 0;
    if (had_one && ahead <= StreamAcknowledgement::window) stream.before |= 1ULL << (ahead - 1);
    stream.highest = number;
    stream.last = now;
  } else if (number < stream.highest) {
    stream.before |= 1ULL << (stream.highest - number - 1);
  }
  stream.noted = now;
  stream.low.reset();
}

bool LinkReceiver::is_contrary(Stream& stream, TransmissionNumber number, Time now) {
  // A few that overtake each other are of one sender.
  if (!stream.low || number + StreamAcknowledgement::window < stream.low->first) {
    stream.low = {number, now};
    return false;
  }
  stream.low->first = std::max(stream.low->first, number);
  return now - stream.low->second >= contrary_for;
}

Disposition LinkReceiver::judge(Peer& peer, const StreamRule& rule, const Origin& origin,
                                Time now) {
  const Duration age = peer.age.age(origin.sent, now);
  SourceMemory& memory = memory_of(peer, rule.name, origin.source);
  const bool is_fresh = age <= fresh && peer.age.is_settled(now);
  switch (memory.judge(origin.sequence, rule.depth, is_fresh, now)) {
    case SourceMemory::Verdict::duplicate:
      return Disposition::duplicate;
    case SourceMemory::Verdict::superseded:
      return Disposition::superseded;
    case SourceMemory::Verdict::newer:
      break;
  }
  if (age > rule.lifespan - std::min(least_way, rule.lifespan / 100)) return Disposition::expired;
  memory.add(origin.sequence, rule.depth, now);
  return Disposition::deliver;
}

SourceMemory& LinkReceiver::memory_of(Peer& peer, const std::string& stream, SourceId source) {
  const auto [place, is_new] = peer.delivered.try_emplace({stream, source});
  if (is_new && peer.delivered.size() > most_memories) {
    auto oldest = peer.delivered.end();
    for (auto it = peer.delivered.begin(); it != peer.delivered.end(); ++it) {
      if (it == place) continue;
      if (oldest == peer.delivered.end() || it->second.received() < oldest->second.received()) {
        oldest = it;
      }
    }
    peer.delivered.erase(oldest);
  }
  return place->second;
}

void LinkReceiver::ask_for_acknowledgement(Peer& peer, Time now, Duration period) {
  Time due = now + acknowledgement_delay;
  if (peer.acknowledgement_sent) due = std::max(due, *peer.acknowledgement_sent + period);
  peer.acknowledgement_due = std::min(peer.acknowledgement_due, due);
}

void LinkReceiver::ask_for_acknowledgement(const std::string& peer, Time now) {
  const auto known = peers_.find(peer);
  if (known == peers_.end() || !known->second.instance) return;
  ask_for_acknowledgement(known->second, now, period_);
}

std::optional<LinkReceiver::Addressed> LinkReceiver::take_acknowledgement(Time now) {
  for (auto& [name, peer] : peers_) {
    if (peer.acknowledgement_due > now) continue;
    const auto paths = paths_back(peer);
    return Addressed{name, make_acknowledgement(peer, now), paths};
  }
  return std::nullopt;
}

std::array<bool, most_paths> LinkReceiver::paths_back(Peer& peer) {
  const auto paths = std::exchange(peer.came_by, {});
  return paths[0] || paths[1] ? paths : std::array{true, true};
}

LinkAcknowledgement LinkReceiver::make_acknowledgement(Peer& peer, Time now) const {
  LinkAcknowledgement acknowledgement{++peer.acknowledgements, now, {}};
  // After a silence everything is reported once more.
  const bool idle = !peer.acknowledgement_sent || now - *peer.acknowledgement_sent >= all_after;
  for (const auto& [id, stream] : peer.streams) {
    if (stream.highest == 0 || (!idle && now - stream.noted > repeated_for)) continue;
    acknowledgement.streams.push_back(
        {id, stream.highest, now - stream.last, stream.before, stream.path});
  }
  peer.acknowledgement_sent = now;
  peer.acknowledgement_due = now + (misses_pieces(peer, now) ? period_ : acknowledgement_idle);
  return acknowledgement;
}

bool LinkReceiver::misses_pieces(const Peer& peer, Time now) {
  return std::any_of(peer.partial.begin(), peer.partial.end(), [now](const auto& entry) {
    const auto& partial = entry.second;
    return std::any_of(partial.begin(), partial.end(),
                       [now](const Partial& one) { return now - one.last < pieces_missed_for; });
  });
}

Time LinkReceiver::deadline() const {
  Time next = never;
  for (const auto& entry : peers_) next = std::min(next, entry.second.acknowledgement_due);
  return next;
}

}  // namespace tocsin::router
