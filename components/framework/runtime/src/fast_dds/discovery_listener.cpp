// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/discovery_listener.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include "foundation/printable.hpp"
#include "transport/packet_filter.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

double seconds_of(const eprosima::fastrtps::Duration_t& duration) {
  if (duration == eprosima::fastrtps::c_TimeInfinite)
    return std::numeric_limits<double>::infinity();
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
template <class Qos>
QosContract contract_of(const Qos& qos) {
  const bool reliable = qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  const bool exclusive = qos.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  QosContract contract;
  contract.reliability = reliable ? Reliability::reliable : Reliability::best_effort;
  contract.durability = kind_of<Durability>(qos.m_durability.kind);
  contract.deadline_s = seconds_of(qos.m_deadline.period);
  contract.liveliness = kind_of<Liveliness>(qos.m_liveliness.kind);
  contract.liveliness_lease_s = seconds_of(qos.m_liveliness.lease_duration);
  contract.ownership = exclusive ? Ownership::exclusive : Ownership::shared;
  contract.partition = qos.m_partition.getNames();
  contract.latency_budget_s = seconds_of(qos.m_latencyBudget.duration);
  contract.destination_order = kind_of<DestinationOrder>(qos.m_destinationOrder.kind);
  contract.presentation = presentation_of(qos.m_presentation);
  contract.representations = representations_of(qos.representation);
  return contract;
}

template <class Data>
AnnouncedEnd end_of(const Data& data, bool writer) {
  const auto& bytes = data.m_qos.m_userData.data_vec();
  const std::string user_data(bytes.begin(), bytes.end());
  return {data.topicName().to_string(),
          data.typeName().to_string(),
          layout_in(user_data),
          writer,
          contract_of(data.m_qos),
          user_data,
          seconds_of(data.m_qos.m_lifespan.duration)};
}

/// Fast DDS tells a participant of its own endpoints, too.
bool owns(const dds::DomainParticipant* self, const rtps::GUID_t& endpoint) {
  return endpoint.guidPrefix == self->guid().guidPrefix;
}

}  // namespace

void DiscoveryListener::on_participant_discovery(dds::DomainParticipant*,
                                                 rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const auto& prefix = info.info.m_guid.guidPrefix;
  const bool gone =
      info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT;
  const std::string name = info.info.m_participantName.to_string();
  if (acquaintance_ == Acquaintance::when_authenticated) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (gone) strangers_.erase(prefix);
    if (info.status == Info::DISCOVERED_PARTICIPANT) strangers_[prefix] = name;
    if (!gone) return;
    filter_->forget(prefix);
  }
  const auto& data = info.info.m_userData;
  gone ? ends_.remove(prefix) : ends_.add(prefix, name, {data.begin(), data.end()});
}

void DiscoveryListener::onParticipantAuthentication(dds::DomainParticipant*,
                                                    rtps::ParticipantAuthenticationInfo&& info) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto stranger = strangers_.find(info.guid.guidPrefix);
  if (stranger == strangers_.end()) return;
  const std::string name = stranger->second;
  const bool authorized =
      info.status == rtps::ParticipantAuthenticationInfo::AUTHORIZED_PARTICIPANT;
  // A message that anybody has sent in its name may have been refused; its own may follow.
  if (authorized) strangers_.erase(stranger);
  lock.unlock();
  if (authorized) {
    filter_->authenticate(info.guid.guidPrefix);
    ends_.add(info.guid.guidPrefix, name);
  } else {
    log_.warn("participant '{}' is refused: its identity is not accepted", printable(name));
  }
}

void DiscoveryListener::on_publisher_discovery(dds::DomainParticipant* self,
                                               rtps::WriterDiscoveryInfo&& info) {
  if (owns(self, info.info.guid())) return;
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, true));
  }
}

void DiscoveryListener::on_subscriber_discovery(dds::DomainParticipant* self,
                                                rtps::ReaderDiscoveryInfo&& info) {
  if (owns(self, info.info.guid())) return;
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, false));
  }
}

}  // namespace tocsin
