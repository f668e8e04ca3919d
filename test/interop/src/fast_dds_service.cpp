// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_service.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <stdexcept>

#include "runtime/testing/bytes_type.hpp"

namespace tocsin::interop {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

}  // namespace

FastDdsService::FastDdsService(int domain, const Half& written, const Half& read)
    : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
          static_cast<std::uint32_t>(domain), dds::PARTICIPANT_QOS_DEFAULT)) {
  if (participant_ == nullptr) throw std::runtime_error("Fast DDS: no participant");
  dds::DataReaderQos reader;
  reader.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  reader.history().depth = 10;
  reader_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
                ->create_datareader(topic(read), reader);
  dds::DataWriterQos writer;
  writer.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  writer.history().depth = 10;
  writer_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
                ->create_datawriter(topic(written), writer);
}

FastDdsService::~FastDdsService() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* FastDdsService::topic(const Half& half) {
  dds::TypeSupport(new testing::BytesType(half.type)).register_type(participant_);
  return participant_->create_topic(half.topic, half.type, dds::TOPIC_QOS_DEFAULT);
}

bool FastDdsService::is_connected() const {
  dds::PublicationMatchedStatus readers;
  dds::SubscriptionMatchedStatus writers;
  (void)writer_->get_publication_matched_status(readers);
  (void)reader_->get_subscription_matched_status(writers);
  return readers.current_count > 0 && writers.current_count > 0;
}

std::int64_t FastDdsService::write(const Bytes& bytes, const Identity& related) {
  Bytes copy = bytes;
  rtps::WriteParams params;
  params.related_sample_identity(related);
  (void)writer_->write(&copy, params);
  return params.sample_identity().sequence_number().to64long();
}

std::optional<FastDdsService::Taken> FastDdsService::take() {
  Taken taken;
  dds::SampleInfo info;
  while (reader_->take_next_sample(&taken.bytes, &info) == dds::RETCODE_OK) {
    if (!info.valid_data) continue;
    taken.identity = info.sample_identity;
    taken.related = info.related_sample_identity;
    return taken;
  }
  return std::nullopt;
}

}  // namespace tocsin::interop
