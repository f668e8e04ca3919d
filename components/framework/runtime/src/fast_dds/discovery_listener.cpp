// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/discovery_listener.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "foundation/printable.hpp"
#include "transport/packet_filter.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;

double seconds_of(const dds::Duration_t& duration) {
  if (duration == dds::c_TimeInfinite) return std::numeric_limits<double>::infinity();
  return duration.seconds + duration.nanosec * 1e-9;
}

/// DDS numbers its kinds as our enums do; the last one for a number that no specification knows.
template <class Enum>
Enum kind_of(int number) {
  constexpr std::size_t last = words_of(Enum{}).size() - 1;
  return static_cast<Enum>(std::min(static_cast<std::size_t>(number), last));
}

Presentation presentation_of(const dds::PresentationQosPolicy& policy) {
  return {kind_of<PresentationScope>(policy.access_scope), policy.coherent_access,
          policy.ordered_access};
}

/// None is XCDR1 (DDS-XTypes 1.3, section 7.6.3.1).
std::vector<Representation> representations_of(const dds::DataRepresentationQosPolicy& policy) {
  if (policy.m_value.empty()) return {Representation::xcdr1};
  std::vector<Representation> all;
  for (const auto one : policy.m_value) all.push_back(kind_of<Representation>(one));
  return all;
}

/// What an end offers or requests, in the words of a QoS profile.
QosContract contract_of(const fast_dds::DiscoveredEnd& end) {
  const bool reliable = end.reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  const bool exclusive = end.ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  QosContract contract;
  contract.reliability = reliable ? Reliability::reliable : Reliability::best_effort;
  contract.durability = kind_of<Durability>(end.durability.kind);
  contract.deadline_s = seconds_of(end.deadline.period);
  contract.liveliness = kind_of<Liveliness>(end.liveliness.kind);
  contract.liveliness_lease_s = seconds_of(end.liveliness.lease_duration);
  contract.ownership = exclusive ? Ownership::exclusive : Ownership::shared;
  contract.partition = end.partition.getNames();
  contract.latency_budget_s = seconds_of(end.latency_budget.duration);
  contract.destination_order = kind_of<DestinationOrder>(end.destination_order.kind);
  contract.presentation = presentation_of(end.presentation);
  contract.representations = representations_of(end.representation);
  return contract;
}

}  // namespace

void DiscoveryListener::on_participant(const fast_dds::DiscoveredParticipant& participant,
                                       fast_dds::Presence presence) {
  const bool gone = presence == fast_dds::Presence::gone;
  if (acquaintance_ == Acquaintance::when_authenticated) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (gone) {
      strangers_.erase(participant.prefix);
      authenticated_.erase(participant.prefix);
      filter_->forget(participant.prefix);
    } else if (presence == fast_dds::Presence::changed) {
      return;  // Fast DDS 2.9 takes announcements of anybody in its name
    } else if (authenticated_.count(participant.prefix) == 0) {
      strangers_[participant.prefix] = participant.name;
      return;
    }
  }
  gone ? ends_.remove(participant.prefix)
       : ends_.add(participant.prefix, participant.name, participant.user_data);
}

/// Fast DDS 2.9 tells of it after the participant was found, Fast DDS 3 before.
void DiscoveryListener::on_authentication(const Prefix& participant, bool authorized) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto stranger = strangers_.find(participant);
  const bool is_found = stranger != strangers_.end();
  const std::string name = is_found ? stranger->second : "";  // may be empty: Cyclone DDS has none
  // A message that anybody has sent in its name may have been refused; its own may follow.
  if (authorized) {
    authenticated_.insert(participant);
    strangers_.erase(participant);
  }
  lock.unlock();
  if (authorized) {
    filter_->authenticate(participant);
    if (is_found) ends_.add(participant, name);
  } else if (is_found) {
    log_.warn("participant '{}' is refused: its identity is not accepted", printable(name));
  }
}

void DiscoveryListener::on_end(const fast_dds::DiscoveredEnd& end, bool writer,
                               fast_dds::Presence presence) {
  if (presence == fast_dds::Presence::gone) return ends_.remove(end.guid);
  ends_.add(end.guid, {end.topic, end.type, layout_in(end.user_data), writer, contract_of(end),
                       end.user_data, seconds_of(end.lifespan.duration)});
}

}  // namespace tocsin
