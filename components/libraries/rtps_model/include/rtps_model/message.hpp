// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "foundation/time.hpp"

/// RTPS as Fast DDS 2.9.1 speaks it, without bytes: what is sent when, and how long it is.
namespace tocsin::rtps {

/// Number of a sample at its writer, from 1.
using Sequence = std::uint64_t;
/// Number of a piece of a sample, from 1.
using Fragment = std::uint32_t;
/// One end of a topic, as the other end knows it.
using EndId = std::uint64_t;

/// What a submessage or message adds to its content, in bytes (DDSI-RTPS 2.2, 9.4).
namespace wire {
inline constexpr std::size_t ip_and_udp = 28;
inline constexpr std::size_t message_header = 20;
inline constexpr std::size_t info_destination = 16;  ///< when one participant is addressed
inline constexpr std::size_t info_timestamp = 12;    ///< before each DATA and DATA_FRAG
inline constexpr std::size_t data_header = 24;
inline constexpr std::size_t data_fragment_header = 36;
/// Ends every message: the vendor's submessage 0x80, since Debian builds with statistics.
inline constexpr std::size_t statistics = 60;
inline constexpr std::size_t heartbeat = 32;
inline constexpr std::size_t longest_message = 1400;  ///< without IP and UDP; the runtime sets it
/// Most of a sample that fits a message: Fast DDS keeps room for a destination and a heartbeat, and
/// measures whole samples as if they were fragments.
inline constexpr std::size_t largest_payload = longest_message - message_header - info_destination -
                                               info_timestamp - data_fragment_header - heartbeat -
                                               statistics;
/// Numbers that one ACKNACK, NACK_FRAG or GAP can list.
inline constexpr std::size_t longest_list = 256;
}  // namespace wire

/// A sample in the history of a writer; readers share it.
struct Sample {
  Sequence sequence = 0;
  Time written{};
  std::size_t bytes = 0;                ///< serialised
  std::size_t fragment_bytes = 0;       ///< 0: it is sent whole
  std::shared_ptr<const void> content;  ///< the caller's
  /// 0 when it is sent whole.
  [[nodiscard]] Fragment fragments() const;
  /// Bytes of one piece, or of the whole when `fragment` is 0.
  [[nodiscard]] std::size_t bytes_of(Fragment fragment) const;
};
using SamplePtr = std::shared_ptr<const Sample>;

/// DATA, or DATA_FRAG with one fragment.
struct Data {
  SamplePtr sample;
  Fragment fragment = 0;  ///< 0: the whole sample
};

/// What a writer's history holds; `last` is `first` - 1 when it holds nothing. Never final: each is
/// answered.
struct Heartbeat {
  Sequence first;
  Sequence last;
  std::uint32_t count;
};

/// Samples that will not come: those from `first` to before `end`, and `others` after it.
struct Gap {
  Sequence first;
  Sequence end;
  std::vector<Sequence> others;
};

/// Of sequences in rising order, at least one.
[[nodiscard]] Gap gap_of(const std::vector<Sequence>& absent);

/// All before `base` are there; those in `missing`, from `base` on, are wanted.
struct AckNack {
  Sequence base;  ///< 0: nothing was heard of the writer yet
  std::vector<Sequence> missing;
  std::uint32_t count;
};

/// Wanted pieces of one sample.
struct NackFrag {
  Sequence sequence;
  std::vector<Fragment> missing;
  std::uint32_t count;
};

using Submessage = std::variant<Data, Heartbeat, Gap, AckNack, NackFrag>;

/// Length on the wire, with the time stamp of a DATA. Submessages begin at multiples of 4.
[[nodiscard]] std::size_t size_of(const Submessage& submessage);

/// One UDP datagram.
struct Message {
  std::vector<Submessage> parts;
  std::size_t ip_bytes = 0;
};
using MessagePtr = std::shared_ptr<const Message>;

/// The way of messages to the other end.
class Sender {
 public:
  virtual ~Sender() = default;
  virtual void send(EndId to, const MessagePtr& message) = 0;
};

/// IP packets of a sample that goes to `receivers` participants alone in its message, in order.
[[nodiscard]] std::vector<std::size_t> packets_of(std::size_t bytes, std::size_t receivers,
                                                  std::size_t fragment_bytes);

}  // namespace tocsin::rtps
