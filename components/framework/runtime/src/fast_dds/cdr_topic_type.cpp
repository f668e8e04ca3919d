// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/cdr_topic_type.hpp"

#include "fast_dds/instance_key.hpp"

namespace tocsin {
namespace {

constexpr std::uint32_t first_bytes = 256;

}  // namespace

CdrTopicType::CdrTopicType(const TypeInfo& type)
    : TopicType(type.name, first_bytes, type.longest_key > 0), type_(type) {}

std::size_t CdrTopicType::encode(const void* data, std::uint8_t* to, std::size_t capacity) {
  const auto& outgoing =
      *static_cast<const OutgoingSample*>(static_cast<const CarriedMessage*>(data));
  outgoing.bytes = type_.serialize(outgoing.content, to, capacity);
  return outgoing.bytes;
}

bool CdrTopicType::decode(const std::uint8_t* from, std::size_t size, void* data) {
  auto& incoming = *static_cast<IncomingSample*>(static_cast<CarriedMessage*>(data));
  if (incoming.skip) return true;
  incoming.message = type_.create();
  incoming.bytes = static_cast<std::uint32_t>(size);
  incoming.valid = type_.deserialize(from, size, incoming.message.get());
  incoming.content = incoming.valid ? incoming.message.get() : nullptr;
  return true;  // a sample that cannot be decoded is taken and dropped, not offered again
}

std::size_t CdrTopicType::encoded_size(const void* data) const {
  return type_.serialized_size(static_cast<const CarriedMessage*>(data)->content);
}

bool CdrTopicType::find_key(const void* data, InstanceHandle& hash, bool as_md5) {
  const void* const message = static_cast<const CarriedMessage*>(data)->content;
  return message != nullptr && key_hash(type_, message, as_md5, hash);
}

}  // namespace tocsin
