// SPDX-License-Identifier: Apache-2.0
#include "dds_endpoints.hpp"

#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "cdr_topic_type.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

/// FNV-1a over the GUID of the writer.
std::uint64_t source_of(const eprosima::fastrtps::rtps::GUID_t& guid) {
  std::uint64_t hash = 1469598103934665603ULL;
  const auto add = [&hash](const auto& bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
  };
  add(guid.guidPrefix.value, guid.guidPrefix.size);
  add(guid.entityId.value, guid.entityId.size);
  return hash;
}

Sample sample_of(const IncomingSample& incoming, const dds::SampleInfo& info) {
  Sample sample;
  sample.message = incoming.message;
  sample.received = std::chrono::steady_clock::now();
  sample.sent_wall_ns = info.source_timestamp.to_ns();
  sample.received_wall_ns = info.reception_timestamp.to_ns();
  sample.sequence = info.sample_identity.sequence_number().to64long();
  sample.source = source_of(info.sample_identity.writer_guid());
  sample.bytes = incoming.bytes;
  return sample;
}

}  // namespace

DdsReader::DdsReader(FastDdsParticipant& participant, const std::string& topic,
                     const TypeInfo& type, const QosProfile& qos, TopicExchange& exchange)
    : participant_(participant),
      exchange_(exchange),
      log_("dds " + topic),
      reader_(participant.create_reader(topic, type, qos, *this)) {
  if (reader_ == nullptr) throw EnvironmentError("DDS reader of " + topic + " cannot be created");
}

DdsReader::~DdsReader() { participant_.remove(reader_); }

void DdsReader::on_data_available(Reader* reader) {
  IncomingSample incoming;
  dds::SampleInfo info;
  while (reader->take_next_sample(&incoming, &info) == ReturnCode::RETCODE_OK) {
    if (!info.valid_data || participant_.owns(info.sample_identity.writer_guid())) continue;
    if (incoming.valid) {
      exchange_.deliver(sample_of(incoming, info));
    } else {
      log_.error("a sample of {} bytes is not of this type; dropped", incoming.bytes);
    }
  }
}

void DdsReader::on_requested_incompatible_qos(Reader*,
                                              const dds::RequestedIncompatibleQosStatus& status) {
  log_.error("a writer offers less than this reader requests (DDS policy {}): not matched",
             status.last_policy_id);
}

DdsWriter::DdsWriter(FastDdsParticipant& participant, const std::string& topic,
                     const TypeInfo& type, const QosProfile& qos)
    : participant_(participant),
      log_("dds " + topic),
      writer_(participant.create_writer(topic, type, qos, *this)) {
  if (writer_ == nullptr) throw EnvironmentError("DDS writer of " + topic + " cannot be created");
}

DdsWriter::~DdsWriter() { participant_.remove(writer_); }

bool DdsWriter::send(const void* message) {
  // The overload that returns a bool hides the reason; Fast DDS does not change the message.
  return writer_->write(const_cast<void*>(message), dds::HANDLE_NIL) == ReturnCode::RETCODE_OK;
}

void DdsWriter::silence() {
  std::size_t removed = 0;
  (void)writer_->clear_history(&removed);
}

void DdsWriter::on_publication_matched(Writer*, const dds::PublicationMatchedStatus& status) {
  matched_ = status.current_count;
}

void DdsWriter::on_offered_incompatible_qos(Writer*,
                                            const dds::OfferedIncompatibleQosStatus& status) {
  log_.error("a reader requests more than this writer offers (DDS policy {}): not matched",
             status.last_policy_id);
}

}  // namespace tocsin
