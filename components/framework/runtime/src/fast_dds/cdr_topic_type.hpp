// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <memory>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// What Fast DDS carries through: a message that is written, or that was read.
struct CarriedMessage {
  const void* content = nullptr;
};

/// What take_next_sample fills.
struct IncomingSample : CarriedMessage {
  std::shared_ptr<void> message;
  std::uint32_t bytes = 0;
  bool valid = false;
  bool skip = false;  ///< set before: take the sample off the reader without decoding it
};

/// What `write` is given; it fills in the size.
struct OutgoingSample : CarriedMessage {
  explicit OutgoingSample(const void* message) : CarriedMessage{message} {}
  std::size_t bytes = 0;
};

/// Tells Fast DDS about a type by its TypeInfo. Writers pass an OutgoingSample, readers an
/// IncomingSample, as CarriedMessage. No type object, so that every vendor matches by name.
class CdrTopicType : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;
  explicit CdrTopicType(const TypeInfo& type);
  bool serialize(void* data, Payload* payload) override;
  bool deserialize(Payload* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override { return static_cast<CarriedMessage*>(new IncomingSample); }
  void deleteData(void* data) override {
    delete static_cast<IncomingSample*>(static_cast<CarriedMessage*>(data));
  }
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* hash, bool as_md5) override;

 private:
  const TypeInfo& type_;
};

}  // namespace tocsin
