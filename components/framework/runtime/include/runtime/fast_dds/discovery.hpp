// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <string>

#include "runtime/fast_dds/names.hpp"

#if TOCSIN_FAST_DDS >= 3
#include <fastdds/rtps/builtin/data/ParticipantBuiltinTopicData.hpp>
#include <fastdds/rtps/builtin/data/PublicationBuiltinTopicData.hpp>
#include <fastdds/rtps/builtin/data/SubscriptionBuiltinTopicData.hpp>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.hpp>
#include <fastdds/rtps/reader/ReaderDiscoveryStatus.hpp>
#include <fastdds/rtps/writer/WriterDiscoveryStatus.hpp>
#else
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#endif

namespace tocsin::fast_dds {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

/// What another participant announces of a reader or a writer.
struct DiscoveredEnd {
  rtps::GUID_t guid;
  std::string topic;
  std::string type;
  std::string user_data;
  dds::ReliabilityQosPolicy reliability;
  dds::DurabilityQosPolicy durability;
  dds::DeadlineQosPolicy deadline;
  dds::LivelinessQosPolicy liveliness;
  dds::OwnershipQosPolicy ownership;
  dds::PartitionQosPolicy partition;
  dds::LatencyBudgetQosPolicy latency_budget;
  dds::DestinationOrderQosPolicy destination_order;
  dds::PresentationQosPolicy presentation;
  dds::DataRepresentationQosPolicy representation;
  dds::LifespanQosPolicy lifespan;
};

struct DiscoveredParticipant {
  rtps::GuidPrefix_t prefix;
  std::string name;
  std::string user_data;
};

enum class Presence { found, changed, gone };

/// Of a status of either version.
template <class Status>
[[nodiscard]] Presence presence_of(Status status) {
  if (status == Status::DISCOVERED_PARTICIPANT) return Presence::found;
  const bool gone = status == Status::REMOVED_PARTICIPANT || status == Status::DROPPED_PARTICIPANT;
  return gone ? Presence::gone : Presence::changed;
}

/// What discovery tells, whatever the version of Fast DDS, which holds its locks meanwhile.
class DiscoveryEvents : public dds::DomainParticipantListener {
 protected:
  virtual void on_participant(const DiscoveredParticipant& participant, Presence presence) = 0;
  virtual void on_authentication(const rtps::GuidPrefix_t& participant, bool authorized) = 0;
  /// Of another participant than `self`.
  virtual void on_end(const DiscoveredEnd& end, bool writer, Presence presence) = 0;

 private:
  static std::string text_of(const dds::UserDataQosPolicy& data) {
    return {data.data_vec().begin(), data.data_vec().end()};
  }
  /// Fast DDS tells a participant of its own ends, too.
  void tell(const dds::DomainParticipant* self, const DiscoveredEnd& end, bool writer, bool gone) {
    if (end.guid.guidPrefix == self->guid().guidPrefix) return;
    on_end(end, writer, gone ? Presence::gone : Presence::found);
  }
  void onParticipantAuthentication(dds::DomainParticipant* /*self*/,
                                   rtps::ParticipantAuthenticationInfo&& info) override {
    on_authentication(info.guid.guidPrefix,
                      info.status == rtps::ParticipantAuthenticationInfo::AUTHORIZED_PARTICIPANT);
  }

#if TOCSIN_FAST_DDS >= 3
  template <class Data>
  static DiscoveredEnd end_of(const Data& data) {
    return {data.guid,
            data.topic_name.to_string(),
            data.type_name.to_string(),
            text_of(data.user_data),
            data.reliability,
            data.durability,
            data.deadline,
            data.liveliness,
            data.ownership,
            data.partition,
            data.latency_budget,
            data.destination_order,
            data.presentation,
            data.representation,
            data.lifespan};
  }
  void on_participant_discovery(dds::DomainParticipant* /*self*/,
                                rtps::ParticipantDiscoveryStatus status,
                                const dds::ParticipantBuiltinTopicData& info,
                                bool& /*ignore*/) override {
    on_participant(
        {info.guid.guidPrefix, info.participant_name.to_string(), text_of(info.user_data)},
        presence_of(status));
  }
  void on_data_reader_discovery(dds::DomainParticipant* self, rtps::ReaderDiscoveryStatus status,
                                const dds::SubscriptionBuiltinTopicData& info,
                                bool& /*ignore*/) override {
    tell(self, end_of(info), false, status == rtps::ReaderDiscoveryStatus::REMOVED_READER);
  }
  void on_data_writer_discovery(dds::DomainParticipant* self, rtps::WriterDiscoveryStatus status,
                                const dds::PublicationBuiltinTopicData& info,
                                bool& /*ignore*/) override {
    tell(self, end_of(info), true, status == rtps::WriterDiscoveryStatus::REMOVED_WRITER);
  }
#else
  template <class Data>
  static DiscoveredEnd end_of(const Data& data) {
    const auto& qos = data.m_qos;
    return {data.guid(),
            data.topicName().to_string(),
            data.typeName().to_string(),
            text_of(qos.m_userData),
            qos.m_reliability,
            qos.m_durability,
            qos.m_deadline,
            qos.m_liveliness,
            qos.m_ownership,
            qos.m_partition,
            qos.m_latencyBudget,
            qos.m_destinationOrder,
            qos.m_presentation,
            qos.representation,
            qos.m_lifespan};
  }
  void on_participant_discovery(dds::DomainParticipant* /*self*/,
                                rtps::ParticipantDiscoveryInfo&& info) override {
    const auto& data = info.info.m_userData;
    on_participant({info.info.m_guid.guidPrefix,
                    info.info.m_participantName.to_string(),
                    {data.begin(), data.end()}},
                   presence_of(info.status));
  }
  void on_subscriber_discovery(dds::DomainParticipant* self,
                               rtps::ReaderDiscoveryInfo&& info) override {
    tell(self, end_of(info.info), false, info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
  }
  void on_publisher_discovery(dds::DomainParticipant* self,
                              rtps::WriterDiscoveryInfo&& info) override {
    tell(self, end_of(info.info), true, info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
  }
#endif
};

}  // namespace tocsin::fast_dds
