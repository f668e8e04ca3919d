// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/instance_key.hpp"

#include <algorithm>
#include <vector>

namespace tocsin {
namespace {

constexpr std::size_t hash_bytes = 16;
constexpr std::size_t most_key_bytes = 65'536;

std::vector<std::uint8_t> key_of(const TypeInfo& type, const void* message) {
  std::vector<std::uint8_t> key(std::max(type.longest_key, hash_bytes));
  for (;;) {
    const std::size_t written = type.serialize_key(message, key.data(), key.size());
    if (written > 0 || key.size() >= most_key_bytes) {
      key.resize(written);
      return key;
    }
    key.resize(2 * key.size());  // a text without a bound is counted with 255 characters
  }
}

}  // namespace

bool key_hash(const TypeInfo& type, const void* message, bool as_md5,
              eprosima::fastdds::rtps::InstanceHandle_t& hash) {
  if (type.longest_key == 0) return false;
  const std::vector<std::uint8_t> key = key_of(type, message);
  std::uint8_t bytes[hash_bytes] = {};
  if (as_md5 || type.longest_key > hash_bytes) {
    eprosima::fastdds::MD5 md5;
    md5.init();
    md5.update(key.data(), static_cast<unsigned>(key.size()));
    md5.finalize();
    std::copy_n(md5.digest, hash_bytes, bytes);
  } else {
    std::copy_n(key.begin(), std::min(key.size(), hash_bytes), bytes);
  }
  std::copy_n(bytes, hash_bytes, &hash.value[0]);
  return true;
}

std::uint64_t instance_of(const eprosima::fastdds::rtps::InstanceHandle_t& hash) {
  std::uint64_t number = 14695981039346656037U;  // FNV-1a, as short keys differ in a few bits only
  for (std::size_t i = 0; i < hash_bytes; ++i) {
    number = (number ^ hash.value[i]) * 1099511628211U;
  }
  return number == 0 ? 1 : number;
}

std::uint64_t instance_of(const TypeInfo& type, const void* message) {
  eprosima::fastdds::rtps::InstanceHandle_t hash;
  return key_hash(type, message, false, hash) ? instance_of(hash) : 0;
}

}  // namespace tocsin
