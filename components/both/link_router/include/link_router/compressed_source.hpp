// SPDX-License-Identifier: Apache-2.0
// Samples that cross as what is new in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "link_router/transmission.hpp"

namespace tocsin::router {

/// Compressed samples of a source that its receiver keeps at least; one of them may be a base.
inline constexpr std::size_t kept_bases = 16;
/// [B] A larger sample is no base.
inline constexpr std::size_t largest_base = 8192;

/// Makes a sample smaller for who has `base`; null: nothing. Nothing when it cannot.
using Compress = std::function<std::optional<Sample>(const Sample& plain, const Sample* base)>;

/// One source of a compressed stream, as its sender knows it: which sample all readers have, and
/// whether compression gains anything.
///
/// The base of a sample was acknowledged by every reader, and is one of the last `kept_bases` that
/// were sent compressed: the newest of about its size, as a writer may send messages of several
/// kinds in turn, else the newest. Without one it is compressed by itself; so a receiver that has
/// lost a base, or has a forged one, is without samples for at most as many. Pure.
class CompressedSource {
 public:
  /// A sample on its way for the first time, as it is best sent: compressed, or itself.
  [[nodiscard]] Sample send(const Sample& plain, const Compress& compress);
  /// A sample that was sent compressed has been received by every reader.
  void on_delivered(const Sample& plain);
  /// Somebody else reads from now on, who has no base.
  void on_new_reader();

 private:
  [[nodiscard]] const Sample* base_of(const Sample& plain) const;
  [[nodiscard]] static bool gains(const Sample& compressed, const Sample& plain, bool has_base);

  std::deque<std::uint64_t> sent_;         ///< sequence numbers of the last compressed ones, rising
  std::map<std::uint64_t, Sample> bases_;  ///< of them, what all readers have
  std::size_t resting_bytes_ = 0;          ///< [B] samples no larger than this go as they are,
  unsigned rest_ = 0;                      ///< so many, before it is tried again
};

}  // namespace tocsin::router
