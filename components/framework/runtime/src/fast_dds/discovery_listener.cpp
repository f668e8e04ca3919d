// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/discovery_listener.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

#include <algorithm>
#include <array>
#include <limits>

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

double seconds_of(const eprosima::fastrtps::Duration_t& duration) {
  if (duration == eprosima::fastrtps::c_TimeInfinite)
    return std::numeric_limits<double>::infinity();
  return duration.seconds + duration.nanosec * 1e-9;
}

/// The name of a kind; the last one for a number that no specification knows.
template <std::size_t count>
const char* name_of(const std::array<const char*, count>& names, int kind) {
  return names[std::min(static_cast<std::size_t>(kind), count - 1)];
}

/// What an end offers or requests, in the words of a QoS profile.
template <class Qos>
QosContract contract_of(const Qos& qos) {
  constexpr std::array durabilities{"volatile", "transient_local", "transient", "persistent"};
  constexpr std::array kinds{"automatic", "manual_by_participant", "manual_by_topic"};
  const bool reliable = qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  const bool exclusive = qos.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  QosContract contract;
  contract.reliability = reliable ? "reliable" : "best_effort";
  contract.durability = name_of(durabilities, qos.m_durability.kind);
  contract.deadline_s = seconds_of(qos.m_deadline.period);
  contract.liveliness = name_of(kinds, qos.m_liveliness.kind);
  contract.liveliness_lease_s = seconds_of(qos.m_liveliness.lease_duration);
  contract.ownership = exclusive ? "exclusive" : "shared";
  contract.partition = qos.m_partition.getNames();
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

}  // namespace

void DiscoveryListener::on_participant_discovery(dds::DomainParticipant*,
                                                 rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const auto& prefix = info.info.m_guid.guidPrefix;
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    ends_.remove(prefix);
  } else {
    ends_.add(prefix, info.info.m_participantName.to_string());
  }
}

void DiscoveryListener::on_publisher_discovery(dds::DomainParticipant*,
                                               rtps::WriterDiscoveryInfo&& info) {
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, true));
  }
}

void DiscoveryListener::on_subscriber_discovery(dds::DomainParticipant*,
                                                rtps::ReaderDiscoveryInfo&& info) {
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, false));
  }
}

}  // namespace tocsin
