// SPDX-License-Identifier: Apache-2.0
#include "raw_dds.hpp"

#include <cassert>
#include <cstring>
#include <fastdds/dds/core/condition/StatusCondition.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <vector>

#include "ros_idl/sensor_msgs.hpp"
#include "runtime/fast_dds/fast_cdr.hpp"
#include "runtime/fast_dds/topic_type.hpp"
#include "runtime/fast_dds/transport.hpp"

namespace tocsin::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

using Octets = std::vector<std::uint8_t>;
using Message = sensor_msgs::msg::CompressedImage;

template <class T>
class RawTopicType : public fast_dds::TopicType {
 public:
  explicit RawTopicType(const char* name) : TopicType(name, 8, false) {}

 private:
  [[nodiscard]] void* make() override { return new T; }
  void destroy(void* data) override { delete static_cast<T*>(data); }
  bool find_key(const void*, InstanceHandle&, bool) override { return false; }
};

class OctetsType final : public RawTopicType<Octets> {
 public:
  static constexpr std::uint32_t head = 8;
  OctetsType() : RawTopicType("Octets") {}

 private:
  std::size_t encode(const void* data, std::uint8_t* to, std::size_t /*capacity*/) override {
    const Octets& octets = *static_cast<const Octets*>(data);
    const auto size = static_cast<std::uint32_t>(octets.size());
    const std::uint32_t encapsulation = 0x100;
    std::memcpy(to, &encapsulation, 4);
    std::memcpy(to + 4, &size, 4);
    std::memcpy(to + head, octets.data(), size);
    return head + size;
  }
  bool decode(const std::uint8_t* from, std::size_t size, void* data) override {
    static_cast<Octets*>(data)->assign(from + head, from + size);
    return true;
  }
  [[nodiscard]] std::size_t encoded_size(const void* data) const override {
    return head + static_cast<const Octets*>(data)->size();
  }
};

/// Coded by Fast CDR, as the code is that fastddsgen makes.
class MessageType final : public RawTopicType<Message> {
 public:
  MessageType() : RawTopicType("Message") {}

 private:
  std::size_t encode(const void* data, std::uint8_t* to, std::size_t capacity) override {
    return fast_dds::encode_by_fast_cdr(to, capacity, [data](auto& encoder) {
      const Message& message = *static_cast<const Message*>(data);
      const auto& header = message.header();
      encoder << header.stamp().sec() << header.stamp().nanosec() << header.frame_id()
              << message.format() << message.data();
    });
  }
  bool decode(const std::uint8_t* from, std::size_t size, void* data) override {
    fast_dds::decode_by_fast_cdr(from, size, [data](auto& decoder) {
      Message& message = *static_cast<Message*>(data);
      auto& header = message.header();
      decoder >> header.stamp().sec() >> header.stamp().nanosec() >> header.frame_id() >>
          message.format() >> message.data();
    });
    return true;
  }
  [[nodiscard]] std::size_t encoded_size(const void* data) const override {
    return type_info<Message>().serialized_size(data);
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
  while (reader.take_next_sample(sample, &info) == dds::RETCODE_OK) {
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
