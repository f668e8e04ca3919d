// SPDX-License-Identifier: Apache-2.0
#include "participants.hpp"

#include <algorithm>
#include <chrono>

namespace tocsin::rtps_filter {

namespace {

/// Whether an announcement says what the one before has said, to the last octet.
bool is_same(const Announcement& what, const Octets& content) {
  return what.content.left() == content.size() &&
         std::equal(content.begin(), content.end(), what.content.here());
}

}  // namespace

bool Participants::is_over(const Participant& participant, Time now) const {
  const Duration lease = participant.departure ? participant.departure->wait : participant.lease;
  return now - participant.heard > lease;
}

bool Participants::is_known(const Participant& participant, Source from) const {
  // One socket has one port: where a program of the same host sends by another interface, it has
  // the address of that. Interfaces get listeners at any time.
  const auto& sources = participant.sources;
  return std::any_of(sources.begin(), sources.end(), [&](const Source& known) {
    return limits_.participant_has_address ? known == from : known.port == from.port;
  });
}

bool Participants::is_source(Participant& participant, Source from, Time now) const {
  constexpr std::size_t most_sockets = 8;
  constexpr Duration settling = std::chrono::seconds(60);  // longer than anybody's period
  if (is_known(participant, from)) return true;
  auto& sources = participant.sources;
  const bool elsewhere = limits_.participant_has_address && sources.front().address != from.address;
  if (elsewhere || now - participant.admitted > settling || sources.size() >= most_sockets) {
    return false;
  }
  sources.push_back(from);
  return true;
}

Participants::Known::iterator Participants::erase(Known::iterator at) {
  endpoints_ -= at->second.endpoints.size();
  waiting_ -= at->second.departure ? 1U : 0U;
  return known_.erase(at);
}

Wrong Participants::heard(const Prefix& prefix, Source from, Time now) {
  const auto found = known_.find(prefix);
  if (found == known_.end()) return std::nullopt;
  Participant& participant = found->second;
  if (limits_.participant_has_address && participant.sources.front().address != from.address &&
      !is_over(participant, now)) {
    return DropReason::forged_source;
  }
  participant.heard = now;
  return std::nullopt;
}

Checked<Participants::Verdict> Participants::announced(const Prefix& prefix,
                                                       const Announcement& what, Source from,
                                                       Time now) {
  const auto found = known_.find(prefix);
  if (what.leaves) {
    if (found == known_.end()) return Verdict{};  // and not known to Fast DDS either
    return leaves(found, from, now);
  }
  if (!what.guid) return DropReason::discovery_payload;
  if (found == known_.end()) return admit(prefix, what, from, now);
  Participant& participant = found->second;
  if (!is_source(participant, from, now)) return DropReason::forged_source;
  if (participant.authenticated && !is_same(what, participant.content)) {
    return DropReason::unauthenticated;
  }
  return renew(found, what, now);
}

Checked<Participants::Verdict> Participants::leaves(Known::iterator at, Source from, Time now) {
  Participant& participant = at->second;
  if (!is_known(participant, from)) return DropReason::forged_disposal;
  if (participant.authenticated) return DropReason::unauthenticated;
  const Duration wait = limits_.departure_wait;
  if (wait <= Duration{} || !participant.copy.has_lease() || is_over(participant, now)) {
    erase(at);
    return Verdict{};
  }
  Verdict verdict;
  verdict.hide = true;
  if (participant.departure) return verdict;
  verdict.before.push_back(expect_departure(participant, wait, now));
  return verdict;
}

Octets Participants::expect_departure(Participant& participant, Duration wait, Time now) {
  participant.departure = Departure{now, wait};
  ++waiting_;
  return participant.copy.with(wait, ++participant.number);
}

void Participants::supersede(const Prefix& prefix, Time now) {
  // One that was frozen for less is the same when it goes on.
  constexpr Duration wait = std::chrono::seconds(10);
  const auto found = known_.find(prefix);
  if (found == known_.end()) return;
  Participant& participant = found->second;
  if (participant.departure || !participant.copy.has_lease()) return;
  due_.push_back(expect_departure(participant, wait, now));
}

void Participants::stays(const Prefix& prefix, Time now) {
  // What it sent before it left may still be on its way.
  constexpr Duration settling = std::chrono::milliseconds(300);
  const auto found = known_.find(prefix);
  if (found == known_.end()) return;
  Participant& participant = found->second;
  if (!participant.departure || now - participant.departure->since < settling) return;
  participant.departure.reset();
  --waiting_;
  due_.push_back(participant.copy.with(participant.lease, ++participant.number));
}

Participants::Verdict Participants::renew(Known::iterator at, const Announcement& what, Time now) {
  // A handshake that has not ended by then waits for what will not come.
  constexpr Duration longest_handshake = std::chrono::seconds(10);
  Participant& participant = at->second;
  Verdict verdict{false, what.number, {}};
  const bool same = is_same(what, participant.content);
  const bool late = now - participant.admitted > longest_handshake;
  if (limits_.secured && !participant.authenticated && (!same || late)) {
    // Fast DDS speaks to where the first announcement has told it to until it forgets it.
    verdict.before.push_back(departure_of(at->first, ++participant.number));
    participant.admitted = now;
    participant.number = 0;
  }
  if (!same) {
    if (limits_.departure_wait > Duration{}) {
      verdict.number = std::max(what.number, participant.number + 1);
    }
    participant.content.assign(what.content.here(), what.content.here() + what.content.left());
  }
  participant.number = std::max(participant.number, verdict.number);
  participant.lease = what.lease;
  return verdict;
}

Participants::Known::iterator Participants::longest_silent() {
  auto found = known_.end();
  for (auto at = known_.begin(); at != known_.end(); ++at) {
    if (at->second.authenticated) continue;
    if (found == known_.end() || at->second.heard < found->second.heard) found = at;
  }
  return found;
}

/// Who is authenticated takes no stranger's place: the next instance of a peer is a stranger.
bool Participants::is_full() const {
  constexpr std::size_t authenticated_and_strangers = 4;
  const auto strangers = std::count_if(known_.begin(), known_.end(),
                                       [](const auto& one) { return !one.second.authenticated; });
  return static_cast<std::size_t>(strangers) >= limits_.participants ||
         known_.size() >= authenticated_and_strangers * limits_.participants;
}

bool Participants::make_room(Time now, Verdict& verdict) {
  if (!is_full()) return true;
  for (auto at = known_.begin(); at != known_.end();) {
    at = is_over(at->second, now) ? erase(at) : std::next(at);
  }
  if (!is_full()) return true;
  if (limits_.yields_after <= Duration{}) return false;
  const auto silent = longest_silent();
  if (silent == known_.end() || now - silent->second.heard < limits_.yields_after) return false;
  verdict.before.push_back(departure_of(silent->first, silent->second.number + 1));
  erase(silent);
  return true;
}

Checked<Participants::Verdict> Participants::admit(const Prefix& prefix, const Announcement& what,
                                                   Source from, Time now) {
  // Fast DDS believes the departure of no other.
  if (limits_.yields_after > Duration{} && !what.has_announcer) {
    return DropReason::discovery_payload;
  }
  Verdict verdict{false, what.number, {}};
  if (!make_room(now, verdict)) return DropReason::too_many_participants;
  Participant& participant = known_[prefix];
  participant.sources = {from};
  participant.admitted = participant.heard = now;
  participant.lease = what.lease;
  participant.number = what.number;
  participant.content.assign(what.content.here(), what.content.here() + what.content.left());
  return verdict;
}

void Participants::authenticate(const Prefix& prefix) {
  const auto found = known_.find(prefix);
  if (found != known_.end()) found->second.authenticated = true;
}

void Participants::forget(const Prefix& prefix) {
  const auto found = known_.find(prefix);
  // What the filter itself has made DDS forget is announced again.
  if (found != known_.end() && found->second.authenticated) erase(found);
}

Wrong Participants::endpoint(const Prefix& prefix, const Announcement& what) {
  const auto found = known_.find(prefix);
  if (found == known_.end() || !what.guid) return std::nullopt;  // Fast DDS ignores it, too
  const auto& guid = *what.guid;
  const std::uint32_t entity = ipv4(guid[12], guid[13], guid[14], guid[15]);
  auto& endpoints = found->second.endpoints;
  if (what.leaves) {
    endpoints_ -= endpoints.erase(entity);
    return std::nullopt;
  }
  const auto known = endpoints.find(entity);
  if (known == endpoints.end()) {
    if (endpoints_ >= limits_.endpoints) return DropReason::too_many_endpoints;
    ++endpoints_;
  }
  endpoints[entity] = {};  // its readers may begin anew
  return std::nullopt;
}

ToldNumbers* Participants::told_by(const Prefix& prefix, std::uint32_t writer) {
  constexpr std::uint32_t built_in = 0xc0;  // in the kind of an entity (RTPS 2.5, 9.3.1.2)
  const auto found = known_.find(prefix);
  if (found == known_.end() || (writer & built_in) == built_in) return nullptr;
  const auto endpoint = found->second.endpoints.find(writer);
  return endpoint == found->second.endpoints.end() ? nullptr : &endpoint->second;
}

Checked<Participants::Told> Participants::heartbeat(const Prefix& prefix,
                                                    const Heartbeat& heartbeat, const Addressee& to,
                                                    Time now) {
  ToldNumbers* const told = told_by(prefix, heartbeat.writer);
  const std::int64_t before = told == nullptr ? 1 : told->first(to);
  const std::int64_t first = std::min(heartbeat.first, before + limits_.jump_step);
  const bool jumps = first - before > limits_.jump_free;
  if (jumps && jumps_.is_empty(limits_.jump_cpu_s, now)) return DropReason::sequence_jump;
  if (told != nullptr) told->tell(to, first, heartbeat.count);
  return Told{first, jumps};
}

Wrong Participants::fragment(const Prefix& prefix, const Data& data, Time now) {
  if (told_by(prefix, data.writer) == nullptr) return std::nullopt;  // and nobody takes it
  return unfinished_.add(prefix, data, limits_.unfinished_bytes, now);
}

Wrong Participants::gap(const Prefix& prefix, const Gap& gap, const Addressee& to, Time now) {
  const auto found = known_.find(prefix);
  if (found == known_.end()) return std::nullopt;
  const ToldNumbers* const told = told_by(prefix, gap.writer);
  const bool joins = gap.start <= (told == nullptr ? 1 : told->first(to));
  const std::uint64_t kept = joins ? gap.bits : gap.numbers;
  if (!kept_.take(static_cast<double>(kept), limits_.kept_numbers, now)) {
    return DropReason::gap_range;
  }
  const auto numbers = static_cast<double>(gap.numbers);
  if (!found->second.gaps.take(numbers, limits_.gap_rate, now)) return DropReason::gap_range;
  return std::nullopt;
}

}  // namespace tocsin::rtps_filter
