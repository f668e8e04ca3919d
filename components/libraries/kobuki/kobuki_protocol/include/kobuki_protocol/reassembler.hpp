// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "foundation/bytes.hpp"
#include "kobuki_protocol/frame.hpp"

namespace tocsin::kobuki {

/// Finds the frames in a byte stream, however it is cut into reads.
///
/// The protocol does not escape AA 55 inside payloads, so a rejected frame is searched again from
/// its second byte: a good frame is never lost because a false header swallowed it. A false header
/// can delay good frames by at most 255 bytes (22 ms of line time). Pure, 259 bytes of memory,
/// bounded work per byte, no allocation.
class Reassembler {
 public:
  struct Counts {
    std::uint64_t frames = 0;     ///< with a good checksum
    std::uint64_t rejected = 0;   ///< headers whose length or checksum was wrong
    std::uint64_t discarded = 0;  ///< bytes that belong to no good frame
  };

  /// Takes bytes in any portions and calls `sink(ByteView payload)` for each good frame, in order.
  /// The view is valid during the call only.
  template <class Sink>
  void feed(ByteView bytes, Sink&& sink) {
    for (std::size_t at = 0; at < bytes.size;) {
      const std::size_t count = std::min(missing(), bytes.size - at);
      append(bytes.part(at, count));
      at += count;
      while (const auto payload = find_frame()) {
        sink(*payload);
        remove_frame();
      }
    }
  }

  /// Forgets a half-received frame, for a freshly opened port.
  void clear();

  [[nodiscard]] const Counts& counts() const { return counts_; }
  /// Bytes held back because their frame is not complete yet.
  [[nodiscard]] std::size_t pending() const { return size_; }
  /// Bytes that such a frame lacks, or that tell how long it is; 0: none is under way.
  [[nodiscard]] std::size_t lacking() const { return size_ == 0 ? 0 : missing(); }

 private:
  /// How many bytes can come before there is anything to decide; at least 1.
  [[nodiscard]] std::size_t missing() const;
  void append(ByteView bytes);
  [[nodiscard]] std::optional<ByteView> find_frame();
  void remove_frame();
  void drop(std::size_t count);
  void skip_to_header(std::size_t from);
  [[nodiscard]] bool starts_frame_at(std::size_t i) const;

  std::array<std::uint8_t, max_frame> buffer_{};
  std::size_t size_ = 0;
  Counts counts_;
};

}  // namespace tocsin::kobuki
