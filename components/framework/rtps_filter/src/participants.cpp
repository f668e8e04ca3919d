// SPDX-License-Identifier: Apache-2.0
#include "participants.hpp"

#include <algorithm>
#include <chrono>

namespace tocsin::rtps_filter {

bool Participants::is_over(const Participant& participant, Time now) {
  return now - participant.heard > participant.lease;
}

bool Participants::is_source(Participant& participant, Source from, Time now) const {
  constexpr std::size_t most_sockets = 8;
  constexpr Duration settling = std::chrono::seconds(60);  // longer than anybody's period
  auto& sources = participant.sources;
  if (std::find(sources.begin(), sources.end(), from) != sources.end()) return true;
  const bool elsewhere = limits_.participant_has_address && sources.front().address != from.address;
  if (elsewhere || now - participant.admitted > settling || sources.size() >= most_sockets) {
    return false;
  }
  sources.push_back(from);
  return true;
}

Participants::Known::iterator Participants::erase(Known::iterator at) {
  endpoints_ -= at->second.endpoints.size();
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

Wrong Participants::announced(const Prefix& prefix, const Announcement& what, Source from,
                              Time now) {
  const auto found = known_.find(prefix);
  if (what.leaves) {
    if (found == known_.end()) return std::nullopt;  // and not known to Fast DDS either
    const auto& sources = found->second.sources;
    if (std::find(sources.begin(), sources.end(), from) == sources.end()) {
      return DropReason::forged_disposal;
    }
    erase(found);
    return std::nullopt;
  }
  if (!what.guid) return DropReason::discovery_payload;
  if (found == known_.end()) return admit(prefix, what, from, now);
  Participant& participant = found->second;
  if (!is_source(participant, from, now)) return DropReason::forged_source;
  participant.lease = what.lease;
  return std::nullopt;
}

Wrong Participants::admit(const Prefix& prefix, const Announcement& what, Source from, Time now) {
  if (known_.size() >= limits_.participants) {
    for (auto at = known_.begin(); at != known_.end();) {
      at = is_over(at->second, now) ? erase(at) : std::next(at);
    }
  }
  if (known_.size() >= limits_.participants) return DropReason::too_many_participants;
  Participant& participant = known_[prefix];
  participant.sources = {from};
  participant.admitted = participant.heard = now;
  participant.lease = what.lease;
  return std::nullopt;
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

Wrong Participants::gap(const Prefix& prefix, const Gap& gap, Time now) {
  const auto found = known_.find(prefix);
  if (found == known_.end()) return std::nullopt;
  const auto numbers = static_cast<double>(gap.numbers);
  if (!found->second.gaps.take(numbers, limits_.gap_rate, now)) return DropReason::gap_range;
  return std::nullopt;
}

}  // namespace tocsin::rtps_filter
