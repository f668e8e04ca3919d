// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <string>

#include "runtime/fast_dds/names.hpp"

namespace tocsin::fast_dds {

/// What Fast DDS asks of a type, whatever its version. All is XCDR1, little endian.
class TopicType : public eprosima::fastdds::dds::TopicDataType {
 public:
  using Payload = eprosima::fastdds::rtps::SerializedPayload_t;
  using InstanceHandle = eprosima::fastdds::rtps::InstanceHandle_t;
  /// `first_bytes`: a guess; payloads are allocated by their real size.
  TopicType(const std::string& name, std::uint32_t first_bytes, bool has_key);

 protected:
  /// Returns the bytes written, header included; 0: it cannot.
  virtual std::size_t encode(const void* data, std::uint8_t* to, std::size_t capacity) = 0;
  virtual bool decode(const std::uint8_t* from, std::size_t size, void* data) = 0;
  [[nodiscard]] virtual std::size_t encoded_size(const void* data) const = 0;
  [[nodiscard]] virtual void* make() = 0;
  virtual void destroy(void* data) = 0;
  /// False when it has no key.
  virtual bool find_key(const void* data, InstanceHandle& hash, bool as_md5) = 0;

 private:
  bool write(const void* data, Payload& payload) {
    const std::size_t written = encode(data, payload.data, payload.max_size);
    payload.length = static_cast<std::uint32_t>(written);
    payload.encapsulation = CDR_LE;
    return written > 0;
  }

#if TOCSIN_FAST_DDS >= 3
 public:
  using Representation = eprosima::fastdds::dds::DataRepresentationId_t;
  bool serialize(const void* data, Payload& payload, Representation /*wanted*/) override {
    return write(data, payload);
  }
  bool deserialize(Payload& payload, void* data) override {
    return decode(payload.data, payload.length, data);
  }
  std::uint32_t calculate_serialized_size(const void* data, Representation /*wanted*/) override {
    return static_cast<std::uint32_t>(encoded_size(data));
  }
  void* create_data() override { return make(); }
  void delete_data(void* data) override { destroy(data); }
  bool compute_key(const void* data, InstanceHandle& hash, bool as_md5) override {
    return find_key(data, hash, as_md5);
  }
  bool compute_key(Payload& payload, InstanceHandle& hash, bool as_md5) override {
    void* const data = make();
    const bool found = deserialize(payload, data) && find_key(data, hash, as_md5);
    destroy(data);
    return found;
  }
};

inline TopicType::TopicType(const std::string& name, std::uint32_t first_bytes, bool has_key) {
  set_name(name);
  max_serialized_type_size = first_bytes;
  is_compute_key_provided = has_key;
}
#else
 public:
  bool serialize(void* data, Payload* payload) override { return write(data, *payload); }
  bool deserialize(Payload* payload, void* data) override {
    return decode(payload->data, payload->length, data);
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [this, data] { return static_cast<std::uint32_t>(encoded_size(data)); };
  }
  void* createData() override { return make(); }
  void deleteData(void* data) override { destroy(data); }
  bool getKey(void* data, InstanceHandle* hash, bool as_md5) override {
    return find_key(data, *hash, as_md5);
  }
};

inline TopicType::TopicType(const std::string& name, std::uint32_t first_bytes, bool has_key) {
  setName(name.c_str());
  m_typeSize = first_bytes;
  m_isGetKeyDefined = has_key;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}
#endif

}  // namespace tocsin::fast_dds
