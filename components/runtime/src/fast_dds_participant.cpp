// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_participant.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <cmath>
#include <utility>

#include "cdr_topic_type.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

/// RTPS messages that fit one 1500-byte IP packet: IP never fragments on the radio.
constexpr std::uint32_t radio_message_bytes = 1400;

Duration_t duration(double s) {
  if (std::isinf(s)) return eprosima::fastrtps::c_TimeInfinite;
  const double whole = std::floor(s);
  return {static_cast<std::int32_t>(whole), static_cast<std::uint32_t>((s - whole) * 1e9)};
}

std::shared_ptr<UDPv4TransportDescriptor> transport_of(const ParticipantOptions& options) {
  auto transport = std::make_shared<UDPv4TransportDescriptor>();
  transport->interfaceWhiteList = {options.address};
  transport->maxInitialPeersRange = static_cast<std::uint32_t>(options.peer_participants);
  if (options.radio) transport->maxMessageSize = radio_message_bytes;
  return transport;
}

rtps::Locator_t locator_of(const std::string& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(locator, address);
  locator.port = 0;
  return locator;
}

dds::DomainParticipantQos qos_of(const ParticipantOptions& options) {
  dds::DomainParticipantQos qos;
  qos.name(options.name);
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {transport_of(options)};
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  builtin.avoid_builtin_multicast = true;
  builtin.metatrafficUnicastLocatorList.push_back(locator_of(options.address));
  for (const std::string& peer : options.peers) {
    builtin.initialPeersList.push_back(locator_of(peer));
  }
  builtin.discovery_config.leaseDuration = duration(options.radio ? 60 : 5);
  builtin.discovery_config.leaseDuration_announcementperiod = duration(options.radio ? 5 : 1);
  builtin.discovery_config.initial_announcements.count = 10;
  builtin.discovery_config.initial_announcements.period = duration(0.1);
  return qos;
}

template <class Qos>
void apply_common(const QosProfile& profile, Qos& qos) {
  qos.reliability().kind =
      profile.reliable() ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      profile.keeps_last() ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = profile.depth;
  qos.lifespan().duration = duration(profile.lifespan_s);
  qos.resource_limits().max_samples = profile.depth + 1;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = profile.depth;
  qos.resource_limits().allocated_samples = 1;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace

FastDdsParticipant::FastDdsParticipant(ParticipantOptions options) : options_(std::move(options)) {
  participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(options_.domain), qos_of(options_), nullptr,
      dds::StatusMask::none());
  if (participant_ == nullptr) {
    throw EnvironmentError("DDS participant " + options_.name + " in domain " +
                           std::to_string(options_.domain) + " cannot be created on " +
                           options_.address + " (is the address there, are ports free?)");
  }
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
}

FastDdsParticipant::~FastDdsParticipant() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* FastDdsParticipant::topic(const std::string& name, const TypeInfo& type) {
  if (dds::TopicDescription* found = participant_->lookup_topicdescription(name)) {
    return static_cast<dds::Topic*>(found);
  }
  dds::TypeSupport support(new CdrTopicType(type));
  support.register_type(participant_);
  return participant_->create_topic(name, type.name, dds::TOPIC_QOS_DEFAULT);
}

dds::DataWriter* FastDdsParticipant::create_writer(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataWriterListener& listener) {
  dds::DataWriterQos qos;
  apply_common(profile, qos);
  auto& times = qos.reliable_writer_qos().times;
  times.heartbeatPeriod = duration(profile.heartbeat_period_s);
  times.nackResponseDelay = duration(profile.nack_response_delay_s);
  times.nackSupressionDuration = duration(0);
  qos.publish_mode().kind =
      options_.radio ? dds::ASYNCHRONOUS_PUBLISH_MODE : dds::SYNCHRONOUS_PUBLISH_MODE;
  return publisher_->create_datawriter(topic(name, type), qos, &listener);
}

dds::DataReader* FastDdsParticipant::create_reader(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataReaderListener& listener) {
  dds::DataReaderQos qos;
  apply_common(profile, qos);
  qos.reliable_reader_qos().times.heartbeatResponseDelay =
      duration(profile.heartbeat_response_delay_s);
  return subscriber_->create_datareader(topic(name, type), qos, &listener);
}

void FastDdsParticipant::remove(dds::DataWriter* writer) {
  if (writer != nullptr) publisher_->delete_datawriter(writer);
}

void FastDdsParticipant::remove(dds::DataReader* reader) {
  if (reader != nullptr) subscriber_->delete_datareader(reader);
}

bool FastDdsParticipant::owns(const rtps::GUID_t& writer) const {
  return writer.guidPrefix == participant_->guid().guidPrefix;
}

}  // namespace tocsin
