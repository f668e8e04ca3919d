// SPDX-License-Identifier: Apache-2.0
#pragma once

/// A reader of shapes that is Fast DDS's alone: nothing of our runtime stands between.

#include <fastcdr/Cdr.h>
#include <fastrtps/utils/md5.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <string>
#include <vector>

namespace tocsin::shapes {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

/// Of a shape only what is its key.
class PlainShapeType : public dds::TopicDataType {
 public:
  PlainShapeType() {
    setName("ShapeType");
    m_typeSize = 1024;
    m_isGetKeyDefined = true;
  }
  bool serialize(void*, rtps::SerializedPayload_t*) override { return false; }  // it only reads
  bool deserialize(rtps::SerializedPayload_t* payload, void* color) override {
    FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    cdr >> *static_cast<std::string*>(color);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return 0U; };
  }
  void* createData() override { return new std::string; }
  void deleteData(void* color) override { delete static_cast<std::string*>(color); }
  bool getKey(void* color, rtps::InstanceHandle_t* handle, bool) override {
    std::array<char, 256> bytes{};
    FastBuffer buffer(bytes.data(), bytes.size());
    Cdr cdr(buffer, Cdr::BIG_ENDIANNESS);
    cdr << *static_cast<std::string*>(color);
    MD5 digest;
    digest.init();
    digest.update(bytes.data(), static_cast<unsigned>(cdr.getSerializedDataLength()));
    digest.finalize();
    for (unsigned i = 0; i < 16; ++i) handle->value[i] = digest.digest[i];
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
    while (reader_->take_next_sample(&color, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
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
