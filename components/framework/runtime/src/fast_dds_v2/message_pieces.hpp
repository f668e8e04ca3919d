// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/middleware/link_limits.hpp"

namespace tocsin {

/// A secured link's way to keep packets below `radio_message_bytes`. What DDS Security has sealed
/// cannot be divided any more, and Fast DDS 2.9.1 sends messages of authentication, of 4 to 5 kB,
/// whole or not at all. So a longer message goes as pieces: RTPS messages with its header and one
/// submessage of a kind that RTPS leaves to vendors. In it, little endian: number of the message,
/// its size, place of the piece (4 bytes each), the bytes, zeros up to a multiple of four.
///
/// Cuts up one sender's messages. One thread at a time.
class MessagePieces {
 public:
  /// The message itself when it is short enough, else its pieces. At most 65,507 bytes.
  [[nodiscard]] std::vector<std::vector<std::uint8_t>> of(const std::uint8_t* message,
                                                          std::size_t size);

 private:
  std::uint32_t number_ = 0;
};

/// Of the message that a packet is a piece of; nothing when it is none.
[[nodiscard]] std::optional<std::uint32_t> piece_number(const std::uint8_t* bytes,
                                                        std::size_t size);

/// Puts messages together from their pieces, which may come in any order. Pure; one thread at a
/// time. Of many unfinished messages the oldest is forgotten.
class PieceAssembly {
 public:
  /// Unfinished messages of all senders that are kept, and for how long.
  static constexpr std::size_t most_open = 64;
  static constexpr Duration longest_wait = std::chrono::seconds(2);

  /// What the bytes were.
  struct Result {
    bool piece = false;  ///< of a message: not to be read by itself
    std::optional<std::vector<std::uint8_t>> whole = {};  ///< the message that it completes
  };
  /// `sender`: where the packet came from. Sizes and places that do not fit are ignored.
  [[nodiscard]] Result add(const std::uint8_t* bytes, std::size_t size, std::uint64_t sender,
                           Time now);
  [[nodiscard]] std::size_t open() const { return open_.size(); }

 private:
  /// Which message of whom.
  struct Key {
    std::uint64_t sender;
    std::uint32_t number;
    std::array<std::uint8_t, 20> header;
    std::size_t bytes;
  };
  friend bool operator==(const Key& one, const Key& other);
  struct Open {
    Key key;
    Time begun;
    std::size_t missing;  ///< pieces
    std::vector<bool> there;
    std::vector<std::uint8_t> message;
  };
  using Opens = std::list<Open>;
  Opens::iterator open_of(const Key& key, Time now);
  Opens open_;  ///< the oldest first
};

}  // namespace tocsin
