// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/cdr_topic_type.hpp"

namespace tocsin {

CdrTopicType::CdrTopicType(const TypeInfo& type) : type_(type) {
  setName(type.name);
  m_typeSize = 256;  // only a first guess: payloads are allocated by their real size
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool CdrTopicType::serialize(void* data, Payload* payload) {
  auto& outgoing = *static_cast<OutgoingSample*>(data);
  const std::size_t written = type_.serialize(outgoing.message, payload->data, payload->max_size);
  outgoing.bytes = written;
  payload->length = static_cast<std::uint32_t>(written);
  payload->encapsulation = CDR_LE;
  return written > 0;
}

bool CdrTopicType::deserialize(Payload* payload, void* data) {
  auto& incoming = *static_cast<IncomingSample*>(data);
  if (incoming.skip) return true;
  incoming.message = type_.create();
  incoming.bytes = payload->length;
  incoming.valid = type_.deserialize(payload->data, payload->length, incoming.message.get());
  return true;  // a sample that cannot be decoded is taken and dropped, not offered again
}

std::function<std::uint32_t()> CdrTopicType::getSerializedSizeProvider(void* data) {
  const void* const message = static_cast<OutgoingSample*>(data)->message;
  return [this, message] { return static_cast<std::uint32_t>(type_.serialized_size(message)); };
}

}  // namespace tocsin
