// SPDX-License-Identifier: Apache-2.0
#include "digest.hpp"

#include <cstring>

namespace tocsin::simulation {

void Digest::add(const std::uint8_t* bytes, std::size_t size) {
  add(static_cast<std::uint64_t>(size));
  for (std::size_t i = 0; i < size; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, size - i < 8 ? size - i : 8);
    add(word);
    value_ ^= value_ >> 32;
  }
}

void Digest::add(std::string_view text) {
  add(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

void Digest::add_sample(Time now, std::string_view writer, const TypeInfo& type,
                        const void* message) {
  buffer_.resize(type.serialized_size(message));
  add(static_cast<std::uint64_t>(now.time_since_epoch().count()));
  add(writer);
  add(buffer_.data(), type.serialize(message, buffer_.data(), buffer_.size()));
}

std::uint64_t Digest::value() const {
  std::uint64_t x = value_;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;  // splitmix64's finish
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace tocsin::simulation
