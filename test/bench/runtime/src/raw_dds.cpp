// SPDX-License-Identifier: Apache-2.0
#include "raw_dds.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <fastrtps/utils/IPLocator.h>

#include <cassert>
#include <cstring>
#include <fastdds/dds/core/condition/StatusCondition.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <vector>

#include "ros_idl/sensor_msgs.hpp"

namespace tocsin::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
namespace cdr = eprosima::fastcdr;
using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

using Octets = std::vector<std::uint8_t>;
using Message = sensor_msgs::msg::CompressedImage;

template <class T>
class RawTopicType : public dds::TopicDataType {
 public:
  explicit RawTopicType(const char* name) {
    setName(name);
    m_typeSize = 8;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  void* createData() override { return new T; }
  void deleteData(void* data) override { delete static_cast<T*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

class OctetsType : public RawTopicType<Octets> {
 public:
  static constexpr std::uint32_t head = 8;
  OctetsType() : RawTopicType("Octets") {}
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Octets& octets = *static_cast<Octets*>(data);
    const auto size = static_cast<std::uint32_t>(octets.size());
    const std::uint32_t encapsulation = 0x100;
    std::memcpy(payload->data, &encapsulation, 4);
    std::memcpy(payload->data + 4, &size, 4);
    std::memcpy(payload->data + head, octets.data(), size);
    payload->length = head + size;
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    Octets& octets = *static_cast<Octets*>(data);
    octets.resize(payload->length - head);
    std::memcpy(octets.data(), payload->data + head, octets.size());
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return head + static_cast<std::uint32_t>(static_cast<Octets*>(data)->size()); };
  }
};

class MessageType : public RawTopicType<Message> {
 public:
  MessageType() : RawTopicType("Message") {}
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    cdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    cdr::Cdr encoder(buffer, cdr::Cdr::LITTLE_ENDIANNESS, cdr::Cdr::DDS_CDR);
    encoder.serialize_encapsulation();
    static_cast<Message*>(data)->serialize(encoder);
    payload->length = static_cast<std::uint32_t>(encoder.getSerializedDataLength());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    cdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    cdr::Cdr decoder(buffer, cdr::Cdr::DEFAULT_ENDIAN, cdr::Cdr::DDS_CDR);
    decoder.read_encapsulation();
    static_cast<Message*>(data)->deserialize(decoder);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] {
      const Message& message = *static_cast<Message*>(data);
      return static_cast<std::uint32_t>(Message::getCdrSerializedSize(message)) + 4U;
    };
  }
};

template <class Qos>
Qos usual(bool reliable) {
  Qos qos;
  qos.reliability().kind =
      reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  qos.history().depth = 4;
  qos.resource_limits().max_samples = 5;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = 5;
  qos.resource_limits().allocated_samples = 5;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  return qos;
}

/// By UDP on one interface, unicast.
dds::DomainParticipantQos udp_qos(const RawLink& link, std::uint32_t message_bytes) {
  using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
  dds::DomainParticipantQos qos;
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {link.address};
  udp->sendBufferSize = udp->receiveBufferSize = 4U << 20U;
  udp->maxMessageSize = message_bytes;
  qos.transport().user_transports = {udp};
  rtps::Locator_t peer;  // lo carries no multicast everywhere
  peer.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(peer, link.peer);
  qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  return qos;
}

dds::DomainParticipant* create(int domain, const dds::DomainParticipantQos& qos, RawType type) {
  dds::DomainParticipant* const participant =
      dds::DomainParticipantFactory::get_instance()->create_participant(
          static_cast<std::uint32_t>(domain), qos, nullptr, dds::StatusMask::none());
  assert(participant != nullptr);
  dds::TopicDataType* const known =
      type == RawType::octets ? static_cast<dds::TopicDataType*>(new OctetsType) : new MessageType;
  dds::TypeSupport(known).register_type(participant);
  return participant;
}

}  // namespace

RawParticipant::RawParticipant(int domain, RawType type)
    : type_(type), participant_(create(domain, udp_qos({"127.0.0.1", "127.0.0.1"}, 65500), type)) {}

RawParticipant::RawParticipant(int domain, const RawLink& link)
    : type_(RawType::message),
      reliable_(false),
      participant_(create(domain, udp_qos(link, 1400), type_)) {}

RawParticipant::~RawParticipant() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

std::shared_ptr<void> RawParticipant::sample(std::size_t octets) const {
  if (type_ == RawType::octets) return std::make_shared<Octets>(octets);
  auto message = std::make_shared<Message>();
  message->data().resize(octets);
  return message;
}

dds::Topic* RawParticipant::topic(const std::string& name) {
  if (auto* found = participant_->lookup_topicdescription(name)) {
    return static_cast<dds::Topic*>(found);
  }
  return participant_->create_topic(name, type_ == RawType::octets ? "Octets" : "Message",
                                    dds::TOPIC_QOS_DEFAULT);
}

dds::DataWriter* RawParticipant::writer(const std::string& name) {
  return participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
      ->create_datawriter(topic(name), usual<dds::DataWriterQos>(reliable_));
}

dds::DataReader* RawParticipant::reader(const std::string& name,
                                        dds::DataReaderListener* listener) {
  return participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
      ->create_datareader(topic(name), usual<dds::DataReaderQos>(reliable_), listener);
}

int take_all(dds::DataReader& reader, void* sample) {
  int count = 0;
  dds::SampleInfo info;
  while (reader.take_next_sample(sample, &info) == ReturnCode::RETCODE_OK) {
    count += info.valid_data ? 1 : 0;
  }
  return count;
}

void RawListener::on_data_available(dds::DataReader* reader) {
  if (take_all(*reader, sample_.get()) > 0) on_sample_(sample_.get());
}

RawWaiter::RawWaiter(dds::DataReader& reader) : reader_(reader) {
  dds::StatusCondition& condition = reader_.get_statuscondition();
  condition.set_enabled_statuses(dds::StatusMask::data_available());
  waits_.attach_condition(condition);
}

int RawWaiter::wait(void* sample) {
  dds::ConditionSeq active;
  (void)waits_.wait(active, {0, 100'000'000});
  return take_all(reader_, sample);
}

RawEcho::RawEcho(RawParticipant& participant, bool silent)
    : silent_(silent),
      sample_(participant.sample(0)),
      reader_(participant.reader("ping")),
      writer_(participant.writer("pong")),
      thread_([this] { run(); }) {}

RawEcho::~RawEcho() {
  stop_ = true;
  thread_.join();
}

void RawEcho::run() {
  RawWaiter waiter(*reader_);
  while (!stop_) {
    if (waiter.wait(sample_.get()) == 0 || silent_) continue;
    (void)writer_->write(sample_.get(), dds::HANDLE_NIL);
  }
}

RawPing::RawPing(RawParticipant& participant, std::size_t octets)
    : ping_(participant.sample(octets)),
      pong_(participant.sample(0)),
      writer_(participant.writer("ping")),
      reader_(participant.reader("pong")),
      waiter_(*reader_) {}

bool RawPing::run(int count, Series& series) {
  for (int i = 0; i < count; ++i) {
    const std::int64_t sent = now_ns();
    (void)writer_->write(ping_.get(), dds::HANDLE_NIL);
    int got = 0;
    for (int tries = 0; got == 0 && tries < 20; ++tries) got = waiter_.wait(pong_.get());
    if (got == 0) return false;
    series.add(now_ns() - sent);
  }
  return true;
}

}  // namespace tocsin::bench
