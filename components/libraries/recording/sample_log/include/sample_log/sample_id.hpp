// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "foundation/hash.hpp"

namespace tocsin::sample_log {

/// One sample over all lives of the process that logs it.
struct SampleId {
  std::uint64_t stream = 0;    ///< stream_key() of its topic
  std::uint64_t source = 0;    ///< its writer
  std::uint64_t sequence = 0;  ///< of that writer, rising, not necessarily by 1
};

[[nodiscard]] inline bool operator==(const SampleId& one, const SampleId& other) {
  return one.stream == other.stream && one.source == other.source && one.sequence == other.sequence;
}
[[nodiscard]] inline bool operator<(const SampleId& one, const SampleId& other) {
  return std::tie(one.stream, one.source, one.sequence) <
         std::tie(other.stream, other.source, other.sequence);
}

/// The number of a stream with this name: the same in every life and on every computer.
[[nodiscard]] inline std::uint64_t stream_key(const std::string& name) { return hash_of(name); }

}  // namespace tocsin::sample_log
