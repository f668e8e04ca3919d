// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/raw_ends.hpp"

#include <algorithm>
#include <utility>

#include "fast_dds/cdr_topic_type.hpp"
#include "idl_support/raw_type.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

std::shared_ptr<const RawReader::Bytes> bytes_of(IncomingSample& incoming) {
  const auto encoded = std::static_pointer_cast<const EncodedMessage>(incoming.message);
  return {encoded, &encoded->bytes};
}

}  // namespace

Gid gid_of(const rtps::GUID_t& guid) {
  Gid gid{};
  const auto rest = std::copy_n(guid.guidPrefix.value, rtps::GuidPrefix_t::size, gid.begin());
  std::copy_n(guid.entityId.value, rtps::EntityId_t::size, rest);
  return gid;
}

RawReader::RawReader(FastDdsParticipant& participant, RawEnd end, OnSample on_sample,
                     OnMatch on_match)
    : participant_(participant),
      end_(std::move(end)),
      on_sample_(std::move(on_sample)),
      on_match_(std::move(on_match)),
      reader_(participant.create_reader(end_.topic, raw_type(end_.type), end_.qos, *this)) {}

RawReader::~RawReader() { participant_.remove(reader_); }

Gid RawReader::gid() const { return gid_of(reader_->guid()); }

void RawReader::on_data_available(Reader* reader) {
  drainer_.run([this, reader] { drain(reader); });
}

void RawReader::drain(Reader* reader) {
  IncomingSample incoming;
  dds::SampleInfo info;
  while (reader->take_next_sample(static_cast<CarriedMessage*>(&incoming), &info) ==
         dds::RETCODE_OK) {
    if (info.valid_data && incoming.valid) on_sample_(bytes_of(incoming), info);
  }
}

void RawReader::on_subscription_matched(Reader*, const dds::SubscriptionMatchedStatus& status) {
  if (!on_match_) return;
  on_match_(rtps::iHandle2GUID(status.last_publication_handle), status.current_count_change > 0);
}

RawWriter::RawWriter(FastDdsParticipant& participant, RawEnd end, OnMatch on_match)
    : participant_(participant),
      end_(std::move(end)),
      on_match_(std::move(on_match)),
      writer_(participant.create_writer(end_.topic, raw_type(end_.type), end_.qos, *this)) {}

RawWriter::~RawWriter() { participant_.remove(writer_); }

bool RawWriter::write(std::vector<std::uint8_t> bytes, rtps::WriteParams& params) {
  const EncodedMessage message{std::move(bytes)};
  OutgoingSample outgoing(&message);
  return fast_dds::is_ok(writer_->write(static_cast<CarriedMessage*>(&outgoing), params));
}

Gid RawWriter::gid() const { return gid_of(writer_->guid()); }

void RawWriter::on_publication_matched(Writer*, const dds::PublicationMatchedStatus& status) {
  if (!on_match_) return;
  on_match_(rtps::iHandle2GUID(status.last_subscription_handle), status.current_count_change > 0);
}

}  // namespace tocsin
