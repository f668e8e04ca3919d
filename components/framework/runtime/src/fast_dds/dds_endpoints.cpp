// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/dds_endpoints.hpp"

#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "fast_dds/cdr_topic_type.hpp"
#include "fast_dds/instance_key.hpp"
#include "fast_dds/raw_ends.hpp"
#include "rtps/origin.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/host_control.hpp"
#include "transport/socket_wait.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

Sample sample_of(IncomingSample& incoming, const dds::SampleInfo& info) {
  Sample sample;
  sample.message = std::move(incoming.message);
  sample.received = std::chrono::steady_clock::now() - waited_in_socket();
  sample.sent_wall_ns = info.source_timestamp.to_ns();
  sample.received_wall_ns = info.reception_timestamp.to_ns();
  const auto origin = origin_in(info.related_sample_identity);  // a router carried it here
  sample.sequence = origin ? origin->sequence : info.sample_identity.sequence_number().to64long();
  sample.source = origin ? origin->source : source_of(info.sample_identity.writer_guid());
  sample.bytes = incoming.bytes;
  if (info.instance_handle.isDefined()) sample.instance = instance_of(info.instance_handle);
  return sample;
}

}  // namespace

DdsReader::DdsReader(FastDdsParticipant& participant, const std::string& topic,
                     const TypeInfo& type, const QosProfile& qos, TopicExchange& exchange)
    : participant_(participant),
      exchange_(exchange),
      skips_own_(!qos.exclusive()),
      own_{topic, type.name, layout_in(qos.user_data), false, qos},
      account_(topic, false),
      reader_(participant.create_reader(topic, type, qos, *this)) {}

DdsReader::~DdsReader() {
  participant_.remove(reader_);  // waits for the listener
  for (const auto& one : sources_) exchange_.forget(one.first);
}

bool DdsReader::next_is_own(Reader* reader) const {
  if (!skips_own_ || !own_matched_) return false;
  dds::SampleInfo info;
  return reader->get_first_untaken_info(&info) == dds::RETCODE_OK &&
         participant_.owns(info.sample_identity.writer_guid());
}

void DdsReader::on_data_available(Reader* reader) {
  drainer_.run([this, reader] { drain(reader); });
}

/// Bytes of another layout may decode by chance; its writer is not believed then.
bool DdsReader::has_other_layout(const RemoteEnds::Guid& writer) {
  if (writer != last_writer_) {
    last_writer_ = writer;
    last_has_other_layout_ = participant_.remote_ends().has_other_layout(writer, own_);
  }
  return last_has_other_layout_;
}

void DdsReader::drain(Reader* reader) {
  IncomingSample incoming;
  auto* const carried = static_cast<CarriedMessage*>(&incoming);
  dds::SampleInfo info;
  for (;;) {
    incoming.skip = next_is_own(reader);  // spares the decoding
    if (reader->take_next_sample(carried, &info) != dds::RETCODE_OK) return;
    if (incoming.skip) continue;
    if (skips_own_ && participant_.owns(info.sample_identity.writer_guid())) continue;
    info.valid_data ? hand_over(incoming, info) : hand_over_end(info);
  }
}

void DdsReader::hand_over_end(const dds::SampleInfo& info) {
  if (!info.instance_handle.isDefined()) return;
  IncomingSample none;
  Sample sample = sample_of(none, info);
  sample.state = info.instance_state == dds::NOT_ALIVE_DISPOSED_INSTANCE_STATE
                     ? InstanceState::disposed
                     : InstanceState::no_writers;
  exchange_.end_instance(sample);
}

void DdsReader::hand_over(IncomingSample& incoming, const dds::SampleInfo& info) {
  if (!incoming.valid || has_other_layout(info.sample_identity.writer_guid())) {
    account_.on_undecodable(incoming.bytes);
  } else if (has_outlived_its_lifespan(info.sample_identity.writer_guid())) {
    account_.on_lost(1);
  } else if (is_first(info)) {
    exchange_.deliver(sample_of(incoming, info));
  }
}

/// While this process was stopped.
bool DdsReader::has_outlived_its_lifespan(const RemoteEnds::Guid& writer) const {
  constexpr Duration at_once = std::chrono::milliseconds(50);  // spares the look at the writer
  const Duration waited = waited_in_socket();
  return waited > at_once && waited > seconds(participant_.remote_ends().writer(writer).lifespan_s);
}

bool DdsReader::is_first(const dds::SampleInfo& info) {
  const auto origin = origin_in(info.related_sample_identity);
  if (!origin) return true;
  const std::lock_guard<std::mutex> lock(sources_mutex_);
  sources_[origin->source] = info.sample_identity.writer_guid();
  return carried_.is_first(origin->source, origin->sequence);
}

std::optional<WriterInfo> DdsReader::writer(std::uint64_t source) const {
  RemoteEnds::Guid guid;
  {
    const std::lock_guard<std::mutex> lock(sources_mutex_);
    const auto found = sources_.find(source);
    if (found == sources_.end()) return std::nullopt;
    guid = found->second;
  }
  return participant_.remote_ends().writer(guid);
}

Gid DdsReader::gid() const { return gid_of(reader_->guid()); }

EndpointHealth DdsReader::health() const {
  EndpointHealth health = account_.health();
  health.other_type = participant_.remote_ends().other_type(own_);
  health.misfit = participant_.remote_ends().misfit(own_);
  return health;
}

bool DdsReader::change(const QosProfile& qos) {
  own_.qos = qos;
  return participant_.change(reader_, qos);
}

void DdsReader::on_subscription_matched(Reader*, const dds::SubscriptionMatchedStatus& status) {
  const rtps::GUID_t writer = rtps::iHandle2GUID(status.last_publication_handle);
  if (participant_.owns(writer)) {
    own_matched_ = status.current_count_change > 0;
    return;
  }
  account_.on_matched(status.current_count_change);
  if (status.current_count_change > 0) {
    const std::lock_guard<std::mutex> lock(sources_mutex_);
    sources_[source_of(writer)] = writer;
  } else {
    forget(writer);
  }
}

void DdsReader::forget(const RemoteEnds::Guid& writer) {
  std::unique_lock<std::mutex> lock(sources_mutex_);
  const std::map<std::uint64_t, RemoteEnds::Guid> known(sources_.begin(), sources_.end());
  lock.unlock();  // whoever hears that an instance has ended may ask for its writer
  for (const auto& [source, its_writer] : known) {
    if (its_writer != writer) continue;
    exchange_.forget(source, std::chrono::steady_clock::now());
    lock.lock();
    const auto found = sources_.find(source);
    if (found != sources_.end() && found->second == writer) sources_.erase(found);
    lock.unlock();
  }
}

void DdsReader::on_requested_incompatible_qos(Reader*,
                                              const dds::RequestedIncompatibleQosStatus& status) {
  account_.on_incompatible(status.last_policy_id, static_cast<int>(status.total_count_change));
}

void DdsReader::on_sample_lost(Reader*, const dds::SampleLostStatus& status) {
  account_.on_lost(status.total_count_change);
}

void DdsReader::on_sample_rejected(Reader*, const dds::SampleRejectedStatus& status) {
  account_.on_lost(static_cast<int>(status.total_count_change));
}

void DdsReader::on_liveliness_changed(Reader*, const dds::LivelinessChangedStatus& status) {
  account_.on_liveliness_lost(status.not_alive_count_change);
}

DdsWriter::DdsWriter(FastDdsParticipant& participant, const std::string& topic,
                     const TypeInfo& type, const QosProfile& qos)
    : participant_(participant),
      own_{topic, type.name, layout_in(qos.user_data), true, qos},
      account_(topic, true),
      writer_(participant.create_writer(topic, type, qos, *this)) {}

DdsWriter::~DdsWriter() { participant_.remove(writer_); }

bool DdsWriter::send(const void* message) {
  OutgoingSample outgoing(message);  // the overload of write that returns a bool hides the reason
  auto* const carried = static_cast<CarriedMessage*>(&outgoing);
  const bool ok = writer_->write(carried, dds::HANDLE_NIL) == dds::RETCODE_OK;
  (ok ? sent_ : refused_).fetch_add(1, std::memory_order_relaxed);
  return ok;
}

Gid DdsWriter::gid() const { return gid_of(writer_->guid()); }

bool DdsWriter::end_instance(const void* message, InstanceState how) {
  OutgoingSample outgoing(message);
  auto* const carried = static_cast<CarriedMessage*>(&outgoing);
  return (how == InstanceState::disposed
              ? writer_->dispose(carried, dds::HANDLE_NIL)
              : writer_->unregister_instance(carried, dds::HANDLE_NIL)) == dds::RETCODE_OK;
}

EndpointHealth DdsWriter::health() const {
  EndpointHealth health = account_.health();
  health.samples = sent_;
  health.lost = refused_;
  health.other_type = participant_.remote_ends().other_type(own_);
  health.misfit = participant_.remote_ends().misfit(own_);
  return health;
}

bool DdsWriter::change(const QosProfile& qos) {
  own_.qos = qos;
  return participant_.change(writer_, qos);
}

void DdsWriter::on_publication_matched(Writer*, const dds::PublicationMatchedStatus& status) {
  if (participant_.owns(rtps::iHandle2GUID(status.last_subscription_handle))) return;
  matched_ += status.current_count_change;
  account_.on_matched(status.current_count_change);
}

void DdsWriter::on_offered_incompatible_qos(Writer*,
                                            const dds::OfferedIncompatibleQosStatus& status) {
  account_.on_incompatible(status.last_policy_id, static_cast<int>(status.total_count_change));
}

void DdsWriter::on_liveliness_lost(Writer*, const dds::LivelinessLostStatus& status) {
  account_.on_liveliness_lost(status.total_count_change);
}

}  // namespace tocsin
