// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "idl_support/type_info.hpp"
#include "runtime/fast_dds/topic_type.hpp"

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
  mutable std::size_t bytes = 0;
};

/// Tells Fast DDS about a type by its TypeInfo. Writers pass an OutgoingSample, readers an
/// IncomingSample, as CarriedMessage. No type object, so that every vendor matches by name.
class CdrTopicType final : public fast_dds::TopicType {
 public:
  explicit CdrTopicType(const TypeInfo& type);

 private:
  std::size_t encode(const void* data, std::uint8_t* to, std::size_t capacity) override;
  bool decode(const std::uint8_t* from, std::size_t size, void* data) override;
  [[nodiscard]] std::size_t encoded_size(const void* data) const override;
  [[nodiscard]] void* make() override { return static_cast<CarriedMessage*>(new IncomingSample); }
  void destroy(void* data) override {
    delete static_cast<IncomingSample*>(static_cast<CarriedMessage*>(data));
  }
  bool find_key(const void* data, InstanceHandle& hash, bool as_md5) override;

  const TypeInfo& type_;
};

}  // namespace tocsin
