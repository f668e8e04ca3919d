// SPDX-License-Identifier: Apache-2.0
#include "digest.hpp"

#include <cstring>

namespace tocsin::simulation {
namespace {

constexpr std::size_t word_bytes = sizeof(std::uint64_t);

std::uint64_t word_at(const std::uint8_t* bytes, std::size_t size) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, size);
  return word;
}

std::uint64_t mixed(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * Digest::prime;
  return sum ^ (sum >> 32);
}

}  // namespace

void Digest::add(const std::uint8_t* bytes, std::size_t size) {
  add(static_cast<std::uint64_t>(size));
  // Pictures are nearly all that is added: the sum stays in a register, four words a turn.
  std::uint64_t sum = value_;
  for (; size >= 4 * word_bytes; size -= 4 * word_bytes, bytes += 4 * word_bytes) {
    for (std::size_t i = 0; i < 4; ++i)
      sum = mixed(sum, word_at(bytes + i * word_bytes, word_bytes));
  }
  for (; size >= word_bytes; size -= word_bytes, bytes += word_bytes) {
    sum = mixed(sum, word_at(bytes, word_bytes));
  }
  value_ = size == 0 ? sum : mixed(sum, word_at(bytes, size));
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
