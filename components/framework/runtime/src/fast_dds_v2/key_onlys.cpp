// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/key_onlys.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "idl_support/key_only.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

// RTPS 2.2 sections 9.4.5.3, 9.3.1.2, 9.6.2.2 and 10.
constexpr std::uint8_t data_kind = 0x15;
constexpr std::uint8_t little_flag = 0x01;
constexpr std::uint8_t inline_qos_flag = 0x02;
constexpr std::uint8_t data_flag = 0x04;
constexpr std::uint8_t key_flag = 0x08;
constexpr std::size_t octets_to_inline_qos_at = 2;
constexpr std::size_t data_writer_at = 8;
constexpr std::size_t parameter_header_bytes = 4;
constexpr std::size_t key_header_bytes = 4;
constexpr std::size_t guid_bytes = 16;
constexpr std::uint16_t pid_sentinel = 0x0001;
constexpr std::uint16_t pid_participant_guid = 0x0050;
constexpr std::uint16_t pid_endpoint_guid = 0x005a;
constexpr std::uint16_t pid_key_hash = 0x0070;
constexpr std::uint16_t pid_status_info = 0x0071;
constexpr std::size_t added_bytes = parameter_header_bytes + guid_bytes;

/// Participants, writers and readers are announced by one writer each.
bool is_of_discovery(const std::uint8_t* writer) {
  constexpr std::array<std::array<std::uint8_t, 4>, 3> writers{
      {{0, 1, 0, 0xc2}, {0, 0, 3, 0xc2}, {0, 0, 4, 0xc2}}};
  for (const auto& one : writers) {
    if (std::memcmp(writer, one.data(), one.size()) == 0) return true;
  }
  return false;
}

/// Of a topic with a key (RTPS 2.2 section 9.3.1.2).
bool is_of_topic(const std::uint8_t* writer) { return writer[3] == 0x02; }

/// A DATA that names something by its key and says that it has ended.
struct KeyOnly {
  std::size_t content;         ///< where the submessage begins in the message, behind its header
  std::size_t inline_qos_end;  ///< before its sentinel
  bool hashed;                 ///< a key hash is among the inline QoS
  bool little;
  const std::uint8_t* writer;
  const std::uint8_t* key;
  std::size_t key_bytes;
};

/// Whether a status (RTPS 2.2 section 9.6.3.4) says that something is disposed or unregistered.
/// Always big endian.
bool says_end(const Submessage& data, std::size_t parameter_at) {
  constexpr std::uint8_t disposed_or_unregistered = 3;
  const std::size_t at = parameter_at + parameter_header_bytes + 3;
  return at < data.bytes && (data.content[at] & disposed_or_unregistered) != 0;
}

/// Fills in what the inline QoS says. False when it is cut off, or tells no end.
bool read_inline_qos(const Submessage& data, KeyOnly& found) {
  std::size_t at = octets_to_inline_qos_at + sizeof(std::uint16_t) +
                   number_at<std::uint16_t>(data.content + octets_to_inline_qos_at, found.little);
  bool ends = false;
  while (at + parameter_header_bytes <= data.bytes) {
    const std::uint16_t id = number_at<std::uint16_t>(data.content + at, found.little);
    if (id == pid_sentinel) {
      found.inline_qos_end = found.content + at;
      found.key = data.content + at + parameter_header_bytes;
      found.key_bytes = data.bytes - at - parameter_header_bytes;
      return ends;
    }
    found.hashed = found.hashed || id == pid_key_hash;
    ends = ends || (id == pid_status_info && says_end(data, at));
    at += parameter_header_bytes +
          number_at<std::uint16_t>(data.content + at + sizeof id, found.little);
  }
  return false;
}

std::optional<KeyOnly> key_only_in(const std::uint8_t* message, const Submessage& one) {
  constexpr std::uint8_t flags = inline_qos_flag | data_flag | key_flag;
  constexpr std::size_t least = data_writer_at + 12;  // entity id and sequence number
  if (one.kind != data_kind || (one.flags & flags) != (inline_qos_flag | key_flag) ||
      one.bytes < least) {
    return std::nullopt;
  }
  KeyOnly found{};
  found.content = static_cast<std::size_t>(one.content - message);
  found.little = (one.flags & little_flag) != 0;
  found.writer = one.content + data_writer_at;
  return read_inline_qos(one, found) ? std::optional(found) : std::nullopt;
}

/// The GUID that a serialized key begins with; null when it does not.
const std::uint8_t* guid_in(const std::uint8_t* key, std::size_t bytes) {
  if (bytes < key_header_bytes + parameter_header_bytes + guid_bytes) return nullptr;
  const bool little = (key[1] & 1U) != 0;
  const std::uint8_t* const parameter = key + key_header_bytes;
  const std::uint16_t id = number_at<std::uint16_t>(parameter, little);
  const bool is_guid = id == pid_participant_guid || id == pid_endpoint_guid;
  return is_guid && number_at<std::uint16_t>(parameter + sizeof id, little) == guid_bytes
             ? parameter + parameter_header_bytes
             : nullptr;
}

/// A message that is copied with changes. What comes before a change is copied with it.
class Copy {
 public:
  Copy(const std::uint8_t* message, std::vector<std::uint8_t>& copy)
      : message_(message), copy_(copy) {
    copy_.clear();
  }
  void add_hash(const KeyOnly& one, const std::uint8_t* guid) {
    constexpr std::size_t length_before_content = 2;
    copy_up_to(one.inline_qos_end);
    std::uint8_t* const length = copied(one.content) - length_before_content;
    const std::uint16_t bytes =
        number_at<std::uint16_t>(length, one.little);  // 0: up to the end of the message
    if (bytes != 0)
      put_number<std::uint16_t>(length, static_cast<std::uint16_t>(bytes + added_bytes),
                                one.little);
    std::array<std::uint8_t, parameter_header_bytes> header{};
    put_number<std::uint16_t>(header.data(), pid_key_hash, one.little);
    put_number<std::uint16_t>(header.data() + 2, guid_bytes, one.little);
    copy_.insert(copy_.end(), header.begin(), header.end());
    copy_.insert(copy_.end(), guid, guid + guid_bytes);
    added_ += added_bytes;
  }
  void make_data(const KeyOnly& one) {
    constexpr std::size_t flags_before_content = 3;
    constexpr std::size_t options_at = 2;
    copy_up_to(static_cast<std::size_t>(one.key - message_) + key_header_bytes);
    std::uint8_t& flags = *(copied(one.content) - flags_before_content);
    flags = static_cast<std::uint8_t>((flags & ~key_flag) | data_flag);
    std::copy_n(key_only_options, sizeof key_only_options,
                copy_.data() + copy_.size() - options_at);
  }
  [[nodiscard]] bool is_changed() const { return from_ > 0; }
  void copy_up_to(std::size_t end) {
    copy_.insert(copy_.end(), message_ + from_, message_ + end);
    from_ = end;
  }

 private:
  /// Where a byte of the message is that was copied since the last addition.
  [[nodiscard]] std::uint8_t* copied(std::size_t at) { return copy_.data() + at + added_; }

  const std::uint8_t* message_;
  std::vector<std::uint8_t>& copy_;
  std::size_t from_ = 0;   ///< of the message, not copied yet
  std::size_t added_ = 0;  ///< bytes
};

void change(const KeyOnly& one, Copy& copy) {
  if (is_of_topic(one.writer)) {
    if (one.key_bytes >= key_header_bytes) copy.make_data(one);
  } else if (!one.hashed && is_of_discovery(one.writer)) {
    if (const auto* const guid = guid_in(one.key, one.key_bytes)) copy.add_hash(one, guid);
  }
}

}  // namespace

std::pair<const std::uint8_t*, std::size_t> with_key_onlys(const std::uint8_t* message,
                                                           std::size_t size,
                                                           std::vector<std::uint8_t>& changed) {
  Copy copy(message, changed);
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (const auto key = key_only_in(message, *one)) change(*key, copy);
  }
  if (!copy.is_changed()) return {message, size};
  copy.copy_up_to(size);
  return {changed.data(), changed.size()};
}

}  // namespace tocsin
