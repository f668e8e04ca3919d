// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/message_pieces.hpp"

#include <algorithm>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

/// Of the kinds that RTPS 2.2 section 9.4.5.1.1 leaves to vendors (0x80 to 0xff).
constexpr std::uint8_t piece_kind = 0xc7;
constexpr std::size_t numbers_bytes = 12;
constexpr std::size_t overhead = header_bytes + submessage_header_bytes + numbers_bytes;
constexpr std::size_t piece_bytes = (radio_message_bytes - overhead) / 4 * 4;
constexpr std::size_t largest_message = 65'507;  // that UDP carries

void append(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  }
}

std::size_t pieces_of(std::size_t size) { return (size + piece_bytes - 1) / piece_bytes; }

struct Piece {
  std::uint32_t number;
  std::size_t whole;  ///< bytes of the message
  std::size_t begin;
  const std::uint8_t* bytes;
  [[nodiscard]] std::size_t length() const { return std::min(piece_bytes, whole - begin); }
};

/// Nothing when it is none; a whole of zero when its numbers do not fit.
std::optional<Piece> piece_in(const std::uint8_t* bytes, std::size_t size) {
  const auto first = Submessages(bytes, size).next();
  if (!first || first->kind != piece_kind) return std::nullopt;
  if (first->bytes < numbers_bytes) return Piece{};
  const std::uint8_t* const at = first->content;
  const auto number = [at](std::size_t i) { return number_at<std::uint32_t>(at + 4 * i, true); };
  const Piece piece{number(0), number(1), number(2), at + numbers_bytes};
  const bool fits = piece.whole > radio_message_bytes && piece.whole <= largest_message &&
                    piece.begin % piece_bytes == 0 && piece.begin < piece.whole &&
                    numbers_bytes + piece.length() <= first->bytes;
  return fits ? piece : Piece{};
}

}  // namespace

std::optional<std::uint32_t> piece_number(const std::uint8_t* bytes, std::size_t size) {
  const auto piece = piece_in(bytes, size);
  return piece && piece->whole > 0 ? std::optional(piece->number) : std::nullopt;
}

std::vector<std::vector<std::uint8_t>> MessagePieces::of(const std::uint8_t* message,
                                                         std::size_t size) {
  if (size <= radio_message_bytes) return {{message, message + size}};
  ++number_;
  std::vector<std::vector<std::uint8_t>> pieces;
  for (std::size_t begin = 0; begin < size; begin += piece_bytes) {
    const std::size_t length = std::min(piece_bytes, size - begin);
    const std::size_t content = numbers_bytes + (length + 3) / 4 * 4;
    std::vector<std::uint8_t> piece(message, message + header_bytes);
    piece.reserve(header_bytes + submessage_header_bytes + content);
    constexpr std::uint8_t little_endian = 1;
    piece.insert(piece.end(), {piece_kind, little_endian, static_cast<std::uint8_t>(content),
                               static_cast<std::uint8_t>(content >> 8U)});
    append(piece, number_);
    append(piece, static_cast<std::uint32_t>(size));
    append(piece, static_cast<std::uint32_t>(begin));
    piece.insert(piece.end(), message + begin, message + begin + length);
    piece.resize(header_bytes + submessage_header_bytes + content);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

bool operator==(const PieceAssembly::Key& one, const PieceAssembly::Key& other) {
  return one.sender == other.sender && one.number == other.number && one.header == other.header &&
         one.bytes == other.bytes;
}

PieceAssembly::Opens::iterator PieceAssembly::open_of(const Key& key, Time now) {
  open_.remove_if([&](const Open& one) { return now - one.begun > longest_wait; });
  const auto found =
      std::find_if(open_.begin(), open_.end(), [&](const Open& one) { return one.key == key; });
  if (found != open_.end()) return found;
  if (open_.size() == most_open) open_.pop_front();
  const std::size_t pieces = pieces_of(key.bytes);
  return open_.insert(open_.end(), {key, now, pieces, std::vector<bool>(pieces),
                                    std::vector<std::uint8_t>(key.bytes)});
}

PieceAssembly::Result PieceAssembly::add(const std::uint8_t* bytes, std::size_t size,
                                         std::uint64_t sender, Time now) {
  const auto piece = piece_in(bytes, size);
  if (!piece) return {};
  if (piece->whole == 0) return {true};
  Key key{sender, piece->number, {}, piece->whole};
  std::copy_n(bytes, header_bytes, key.header.begin());
  const auto open = open_of(key, now);
  std::copy_n(piece->bytes, piece->length(),
              open->message.begin() + static_cast<std::ptrdiff_t>(piece->begin));
  std::vector<bool>::reference there = open->there[piece->begin / piece_bytes];
  if (!there) --open->missing;
  there = true;
  if (open->missing > 0) return {true};
  Result result{true, std::move(open->message)};
  open_.erase(open);
  return result;
}

}  // namespace tocsin
