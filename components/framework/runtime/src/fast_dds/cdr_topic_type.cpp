// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/cdr_topic_type.hpp"

#include "fast_dds/instance_key.hpp"

namespace tocsin {

CdrTopicType::CdrTopicType(const TypeInfo& type) : type_(type) {
  setName(type.name);
  m_typeSize = 256;  // only a first guess: payloads are allocated by their real size
  m_isGetKeyDefined = type.longest_key > 0;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool CdrTopicType::serialize(void* data, Payload* payload) {
  auto& outgoing = *static_cast<OutgoingSample*>(static_cast<CarriedMessage*>(data));
  const std::size_t written = type_.serialize(outgoing.content, payload->data, payload->max_size);
  outgoing.bytes = written;
  payload->length = static_cast<std::uint32_t>(written);
  payload->encapsulation = CDR_LE;
  return written > 0;
}

bool CdrTopicType::deserialize(Payload* payload, void* data) {
  auto& incoming = *static_cast<IncomingSample*>(static_cast<CarriedMessage*>(data));
  if (incoming.skip) return true;
  incoming.message = type_.create();
  incoming.bytes = payload->length;
  incoming.valid = type_.deserialize(payload->data, payload->length, incoming.message.get());
  incoming.content = incoming.valid ? incoming.message.get() : nullptr;
  return true;  // a sample that cannot be decoded is taken and dropped, not offered again
}

std::function<std::uint32_t()> CdrTopicType::getSerializedSizeProvider(void* data) {
  const void* const message = static_cast<CarriedMessage*>(data)->content;
  return [this, message] { return static_cast<std::uint32_t>(type_.serialized_size(message)); };
}

bool CdrTopicType::getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* hash,
                          bool as_md5) {
  const void* const message = static_cast<CarriedMessage*>(data)->content;
  return message != nullptr && key_hash(type_, message, as_md5, *hash);
}

}  // namespace tocsin
