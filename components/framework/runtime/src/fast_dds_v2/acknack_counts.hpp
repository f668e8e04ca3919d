// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Makes Fast DDS 2.9.1 answer a reader that starts anew at a writer that still knows it.
///
/// A peer that has not heard us for a lease forgets our writers. When it finds them again, its
/// readers ask for a HEARTBEAT by a pre-emptive ACKNACK (RTPS 2.2 section 8.4.2.3.4). Where we have
/// not forgotten the peer, Fast DDS ignores it: its count starts again below the last one; and from
/// Cyclone DDS it ignores every one, since its count is 0 and Fast DDS knows a pre-emptive ACKNACK
/// by a base of 0, not by the specification's 1. So the count of each reader at each writer goes on
/// here where it was, and the base of a pre-emptive one becomes 0.
///
/// A reader that hears a HEARTBEAT before it has asked, as when the writer tells all of its
/// readers, asks for the samples themselves, from the first on. Fast DDS takes them for
/// acknowledged since the reader's former life, and never sends them: what the writer announces in
/// discovery stays unknown to the peer. No reader takes back what it has acknowledged, so one whose
/// base is lower than before starts anew, and a pre-emptive ACKNACK is put before what it says. Not
/// in its place: Cyclone DDS asks for the same samples again after a second only. Thread-safe.
class AckNackCounts {
 public:
  /// The message to hand on: `message` itself, or `changed`, which is overwritten.
  [[nodiscard]] std::pair<const std::uint8_t*, std::size_t> translate(
      const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed);

 private:
  using Entity = eprosima::fastdds::rtps::EntityId_t;
  using Pair = std::pair<eprosima::fastdds::rtps::GUID_t, Entity>;  ///< a reader and a writer
  struct Count {
    std::uint32_t heard = 0;  ///< last one of the reader
    std::uint32_t told = 0;   ///< what it became
    std::uint64_t base = 0;   ///< last one of the reader
  };
  struct Heard {
    std::uint32_t count;
    std::uint64_t base;
    bool preemptive;
  };
  struct Told {
    std::optional<std::uint32_t> before;  ///< of a pre-emptive one that is put before it
    std::uint32_t count;
  };
  [[nodiscard]] Told next(const Pair& pair, const Heard& heard);

  std::mutex mutex_;
  std::map<Pair, Count> counts_;
  std::map<Pair, Count> older_;  ///< not heard since counts_ was full the last time
};

}  // namespace tocsin
