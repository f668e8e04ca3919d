// SPDX-License-Identifier: Apache-2.0
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <ros_idl/std_msgs.hpp>
#include <stdexcept>

#include "peer.hpp"
#include "runtime/fast_dds/topic_type.hpp"

namespace tocsin::interop {
namespace {

namespace dds = eprosima::fastdds::dds;
using Message = std_msgs::msg::String;

class StringType final : public fast_dds::TopicType {
 public:
  StringType() : TopicType(type_on_wire, 1024, false) {}

 private:
  std::size_t encode(const void* data, std::uint8_t* to, std::size_t capacity) override {
    return type_info<Message>().serialize(data, to, capacity);
  }
  bool decode(const std::uint8_t* from, std::size_t size, void* data) override {
    return type_info<Message>().deserialize(from, size, data);
  }
  [[nodiscard]] std::size_t encoded_size(const void* data) const override {
    return type_info<Message>().serialized_size(data);
  }
  [[nodiscard]] void* make() override { return new Message; }
  void destroy(void* data) override { delete static_cast<Message*>(data); }
  bool find_key(const void*, InstanceHandle&, bool) override { return false; }
};

class FastDdsPeer : public Peer {
 public:
  explicit FastDdsPeer(const PeerSettings& settings)
      : participant_(dds::DomainParticipantFactory::get_instance()->create_participant(
            static_cast<std::uint32_t>(settings.domain), dds::PARTICIPANT_QOS_DEFAULT)) {
    if (participant_ == nullptr) throw std::runtime_error("Fast DDS: no participant");
    dds::TypeSupport(new StringType).register_type(participant_);
    auto* const topic =
        participant_->create_topic(topic_on_wire, type_on_wire, dds::TOPIC_QOS_DEFAULT);
    dds::DataReaderQos reader;
    reader.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    reader.history().depth = 1000;
    reader_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
                  ->create_datareader(topic, reader);
    dds::DataWriterQos writer;
    writer.durability().kind = dds::VOLATILE_DURABILITY_QOS;
    writer.history().depth = 1000;
    if (settings.lifespan_ms > 0) {
      writer.lifespan().duration = dds::Duration_t(1e-3L * settings.lifespan_ms);
    }
    writer_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
                  ->create_datawriter(topic, writer);
  }
  ~FastDdsPeer() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

  void write(const std::string& text) override {
    Message message;
    message.data(text);
    writer_->write(&message);
  }
  std::vector<HeardText> take() override {
    std::vector<HeardText> texts;
    Message message;
    dds::SampleInfo info;
    while (reader_->take_next_sample(&message, &info) == dds::RETCODE_OK) {
      if (info.valid_data) texts.push_back({message.data(), now_ms()});
    }
    return texts;
  }

 private:
  dds::DomainParticipant* participant_;
  dds::DataReader* reader_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace

std::unique_ptr<Peer> make_fast_dds_peer(const PeerSettings& settings) {
  return std::make_unique<FastDdsPeer>(settings);
}

}  // namespace tocsin::interop
