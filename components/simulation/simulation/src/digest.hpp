// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "foundation/time.hpp"
#include "idl_support/type_info.hpp"

namespace tocsin::simulation {

/// A number that stands for every sample of a run: when, by whom, on which topic, which bytes.
/// FNV-1a with words of eight bytes in place of bytes (eight times faster), little endian.
class Digest {
 public:
  static constexpr std::uint64_t prime = 1099511628211ULL;
  void add(std::uint64_t word) { value_ = (value_ ^ word) * prime; }
  void add(std::string_view text);
  void add_sample(Time now, std::string_view writer, const TypeInfo& type, const void* message);

  /// The words are mixed once more, since the upper bits of a word reach only upper bits.
  [[nodiscard]] std::uint64_t value() const;

 private:
  void add(const std::uint8_t* bytes, std::size_t size);
  std::uint64_t value_ = 14695981039346656037ULL;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace tocsin::simulation
