// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/fast_dds/topic_type.hpp"

namespace tocsin::testing {

/// A type of a bare Fast DDS participant whose messages are bytes as they are on the wire, header
/// included: std::vector<std::uint8_t>.
class BytesType final : public fast_dds::TopicType {
 public:
  using Bytes = std::vector<std::uint8_t>;
  explicit BytesType(const std::string& name) : TopicType(name, 64 * 1024, false) {}

 private:
  std::size_t encode(const void* data, std::uint8_t* to, std::size_t capacity) override {
    const Bytes& bytes = *static_cast<const Bytes*>(data);
    if (bytes.size() > capacity) return 0;
    std::copy(bytes.begin(), bytes.end(), to);
    return bytes.size();
  }
  bool decode(const std::uint8_t* from, std::size_t size, void* data) override {
    static_cast<Bytes*>(data)->assign(from, from + size);
    return true;
  }
  [[nodiscard]] std::size_t encoded_size(const void* data) const override {
    return static_cast<const Bytes*>(data)->size();
  }
  [[nodiscard]] void* make() override { return new Bytes; }
  void destroy(void* data) override { delete static_cast<Bytes*>(data); }
  bool find_key(const void*, InstanceHandle&, bool) override { return false; }
};

}  // namespace tocsin::testing
