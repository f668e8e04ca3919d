// SPDX-License-Identifier: Apache-2.0
#include "discovery_ears.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

template <class Data>
AnnouncedEnd end_of(const Data& data, bool writer) {
  const auto& user_data = data.m_qos.m_userData.data_vec();
  return {data.topicName().to_string(), data.typeName().to_string(),
          layout_in({user_data.begin(), user_data.end()}), writer};
}

}  // namespace

void DiscoveryEars::on_participant_discovery(dds::DomainParticipant*,
                                             rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const auto& prefix = info.info.m_guid.guidPrefix;
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    ends_.remove(prefix);
  } else {
    ends_.add(prefix, info.info.m_participantName.to_string());
  }
}

void DiscoveryEars::on_publisher_discovery(dds::DomainParticipant*,
                                           rtps::WriterDiscoveryInfo&& info) {
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, true));
  }
}

void DiscoveryEars::on_subscriber_discovery(dds::DomainParticipant*,
                                            rtps::ReaderDiscoveryInfo&& info) {
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER) {
    ends_.remove(info.info.guid());
  } else {
    ends_.add(info.info.guid(), end_of(info.info, false));
  }
}

}  // namespace tocsin
