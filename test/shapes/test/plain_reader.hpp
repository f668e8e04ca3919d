// SPDX-License-Identifier: Apache-2.0
#pragma once

/// A reader of shapes that is Fast DDS's alone: nothing of our runtime stands between.

#include <cstdint>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <string>
#include <vector>

#include "runtime/fast_dds/topic_type.hpp"

namespace tocsin::shapes {

namespace dds = eprosima::fastdds::dds;

/// Of a shape only what is its key.
class PlainShapeType final : public fast_dds::TopicType {
 public:
  PlainShapeType() : TopicType("ShapeType", 1024, true) {}

 private:
  std::size_t encode(const void*, std::uint8_t*, std::size_t) override {
    return 0;
  }  // it only reads
  [[nodiscard]] std::size_t encoded_size(const void*) const override { return 0; }
  /// The color comes first: behind the header of 4 bytes its length, and its bytes with a zero.
  bool decode(const std::uint8_t* from, std::size_t size, void* color) override {
    constexpr std::size_t text_at = 8;
    std::uint32_t length = 0;
    if (size < text_at) return false;
    std::memcpy(&length, from + 4, sizeof length);
    if (length == 0 || length > size - text_at) return false;
    static_cast<std::string*>(color)->assign(from + text_at, from + text_at + length - 1);
    return true;
  }
  [[nodiscard]] void* make() override { return new std::string; }
  void destroy(void* color) override { delete static_cast<std::string*>(color); }
  bool find_key(const void* color, InstanceHandle& handle, bool) override {
    const std::string& text = *static_cast<const std::string*>(color);
    const std::string key{'\0', '\0', '\0', static_cast<char>(text.size() + 1)};
    const std::string bytes = key + text + '\0';
    eprosima::fastdds::MD5 digest;
    digest.init();
    digest.update(bytes.data(), static_cast<unsigned>(bytes.size()));
    digest.finalize();
    for (unsigned i = 0; i < 16; ++i) handle.value[i] = digest.digest[i];
    return true;
  }
};

class PlainReader {
 public:
  PlainReader(int domain, const std::string& topic) {
    auto* const factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<std::uint32_t>(domain),
                                               dds::PARTICIPANT_QOS_DEFAULT);
    dds::TypeSupport type(new PlainShapeType);
    type.register_type(participant_);
    auto* const made = participant_->create_topic(topic, "ShapeType", dds::TOPIC_QOS_DEFAULT);
    dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    reader_ =
        participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)->create_datareader(made, qos);
  }
  ~PlainReader() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  PlainReader(const PlainReader&) = delete;
  PlainReader& operator=(const PlainReader&) = delete;

  void take_all() {
    std::string color;
    dds::SampleInfo info;
    while (reader_->take_next_sample(&color, &info) == dds::RETCODE_OK) {
      samples_ += info.valid_data ? 1 : 0;
      if (!info.valid_data) ends_.push_back(info.instance_state);
    }
  }
  [[nodiscard]] int samples() const { return samples_; }
  /// The states of instances that have ended.
  [[nodiscard]] const std::vector<dds::InstanceStateKind>& ends() const { return ends_; }

 private:
  dds::DomainParticipant* participant_;
  dds::DataReader* reader_;
  int samples_ = 0;
  std::vector<dds::InstanceStateKind> ends_;
};

}  // namespace tocsin::shapes
