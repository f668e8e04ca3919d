// SPDX-License-Identifier: Apache-2.0
#include "raw_dds.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>

#include <fastrtps/utils/IPLocator.h>

#include <cassert>
#include <cstring>
#include <fastdds/dds/core/condition/StatusCondition.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

namespace tocsin::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

/// A sequence of octets, coded by one memcpy.
class BytesType : public dds::TopicDataType {
 public:
  static constexpr std::uint32_t head = 8;
  BytesType() {
    setName("Bytes");
    m_typeSize = head;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const std::uint32_t encapsulation = 0x100;
    std::memcpy(payload->data, &encapsulation, 4);
    std::memcpy(payload->data + 4, &size, 4);
    std::memcpy(payload->data + head, bytes.data(), size);
    payload->length = head + size;
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    Bytes& bytes = *static_cast<Bytes*>(data);
    bytes.resize(payload->length - head);
    std::memcpy(bytes.data(), payload->data + head, bytes.size());
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return head + static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

template <class Qos>
Qos usual() {
  Qos qos;
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  qos.history().depth = 4;
  qos.resource_limits().max_samples = 5;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = 5;
  qos.resource_limits().allocated_samples = 5;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  return qos;
}

dds::DomainParticipantQos participant_qos(RawParticipant::Transport transport) {
  using eprosima::fastdds::rtps::SharedMemTransportDescriptor;
  using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
  dds::DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {"127.0.0.1"};
  udp->sendBufferSize = udp->receiveBufferSize = 4U << 20U;
  qos.transport().user_transports = {udp};
  rtps::Locator_t peer;  // lo carries no multicast everywhere
  peer.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(peer, "127.0.0.1");
  qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  if (transport == RawParticipant::Transport::shared_memory) {
    auto memory = std::make_shared<SharedMemTransportDescriptor>();
    memory->segment_size(32U << 20U);
    memory->max_message_size(16U << 20U);
    qos.transport().user_transports.push_back(memory);
  }
  return qos;
}

}  // namespace

RawParticipant::RawParticipant(int domain, Transport transport)
    : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
          static_cast<std::uint32_t>(domain), participant_qos(transport), nullptr,
          dds::StatusMask::none())) {
  assert(participant_ != nullptr);
  dds::TypeSupport(new BytesType).register_type(participant_);
}

RawParticipant::~RawParticipant() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* RawParticipant::topic(const std::string& name) {
  if (auto* found = participant_->lookup_topicdescription(name)) {
    return static_cast<dds::Topic*>(found);
  }
  return participant_->create_topic(name, "Bytes", dds::TOPIC_QOS_DEFAULT);
}

dds::DataWriter* RawParticipant::writer(const std::string& name) {
  return participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
      ->create_datawriter(topic(name), usual<dds::DataWriterQos>());
}

dds::DataReader* RawParticipant::reader(const std::string& name,
                                        dds::DataReaderListener* listener) {
  return participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
      ->create_datareader(topic(name), usual<dds::DataReaderQos>(), listener);
}

int take_all(dds::DataReader& reader, Bytes& bytes) {
  int count = 0;
  dds::SampleInfo info;
  while (reader.take_next_sample(&bytes, &info) == ReturnCode::RETCODE_OK) {
    count += info.valid_data ? 1 : 0;
  }
  return count;
}

void RawListener::on_data_available(dds::DataReader* reader) {
  if (take_all(*reader, bytes_) > 0) on_sample_(bytes_);
}

RawWaiter::RawWaiter(dds::DataReader& reader) : reader_(reader) {
  dds::StatusCondition& condition = reader_.get_statuscondition();
  condition.set_enabled_statuses(dds::StatusMask::data_available());
  waits_.attach_condition(condition);
}

int RawWaiter::wait(Bytes& bytes) {
  dds::ConditionSeq active;
  (void)waits_.wait(active, {0, 100'000'000});
  return take_all(reader_, bytes);
}

RawEcho::RawEcho(RawParticipant& participant, bool silent)
    : silent_(silent),
      reader_(participant.reader("ping")),
      writer_(participant.writer("pong")),
      thread_([this] { run(); }) {}

RawEcho::~RawEcho() {
  stop_ = true;
  thread_.join();
}

void RawEcho::run() {
  RawWaiter waiter(*reader_);
  Bytes bytes;
  while (!stop_) {
    if (waiter.wait(bytes) > 0 && !silent_) (void)writer_->write(&bytes, dds::HANDLE_NIL);
  }
}

RawPing::RawPing(RawParticipant& participant, std::size_t bytes)
    : bytes_(bytes),
      writer_(participant.writer("ping")),
      reader_(participant.reader("pong")),
      waiter_(*reader_) {}

bool RawPing::run(int count, Series& series) {
  Bytes answer;
  for (int i = 0; i < count; ++i) {
    const std::int64_t sent = now_ns();
    (void)writer_->write(&bytes_, dds::HANDLE_NIL);
    int got = 0;
    for (int tries = 0; got == 0 && tries < 20; ++tries) got = waiter_.wait(answer);
    if (got == 0) return false;
    series.add(now_ns() - sent);
  }
  return true;
}

}  // namespace tocsin::bench
