// SPDX-License-Identifier: Apache-2.0
#include "idl_support/raw_type.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace tocsin {
namespace {

const EncodedMessage& encoded(const void* message) {
  return *static_cast<const EncodedMessage*>(message);
}

std::size_t serialize(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  const auto& bytes = encoded(message).bytes;
  if (bytes.size() > capacity) return 0;
  std::copy(bytes.begin(), bytes.end(), buffer);
  return bytes.size();
}

bool deserialize(const std::uint8_t* buffer, std::size_t size, void* message) {
  constexpr std::size_t encapsulation_bytes = 4;
  static_cast<EncodedMessage*>(message)->bytes.assign(buffer, buffer + size);
  return size >= encapsulation_bytes;
}

TypeInfo raw(const char* name) {
  TypeInfo type{};
  type.name = name;
  type.create = []() -> std::shared_ptr<void> { return std::make_shared<EncodedMessage>(); };
  type.serialized_size = [](const void* message) { return encoded(message).bytes.size(); };
  type.serialize = serialize;
  type.deserialize = deserialize;
  type.visit = [](const void*, FieldVisitor&) {};
  type.edit = [](void*, FieldEditor&) {};
  return type;
}

}  // namespace

const TypeInfo& raw_type(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, TypeInfo> types;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto place = types.try_emplace(name);
  if (place.second) place.first->second = raw(place.first->first.c_str());
  return place.first->second;
}

}  // namespace tocsin
