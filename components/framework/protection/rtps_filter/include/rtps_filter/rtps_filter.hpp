// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "rtps_filter/drop_reason.hpp"
#include "rtps_filter/limits.hpp"
#include "rtps_filter/source.hpp"

namespace tocsin::rtps_filter {

/// What is to be done with a packet.
struct Inspection {
  std::optional<DropReason> drop;  ///< set: the participant must not see the packet
  /// Places of parameters in the packet that the participant must not read. Their parameter id, two
  /// bytes there, becomes PID_PAD (zero) before the packet is handed on.
  std::vector<std::size_t> strip;
  /// Places of submessages in the packet that the participant must not read. Their kind, one byte
  /// there, becomes PAD before the packet is handed on.
  std::vector<std::size_t> hide;
  /// Places in the packet whose bytes are replaced before it is handed on: the first and last
  /// number of HEARTBEATs that are too far ahead by a step towards it, with no sample to ask for
  /// (16 bytes); numbers and leases of announcements (8 bytes).
  struct Step {
    static constexpr std::size_t of_heartbeat = 16;
    std::size_t at;
    std::size_t size;
    std::array<std::uint8_t, of_heartbeat> bytes;
  };
  std::vector<Step> step;
  /// The participant may walk over many numbers: the CPU time that it takes for the packet is to be
  /// told to RtpsFilter::took.
  bool jumps = false;
  /// Messages that the participant is to be shown before the packet, whole and stripped already: an
  /// announcement of which the last fragment was hidden, or what the filter itself says of a
  /// participant. Mostly empty.
  std::vector<std::vector<std::uint8_t>> before;
};

/// A copy of a packet without what must not be read, and with what takes its place.
[[nodiscard]] std::vector<std::uint8_t> changed(const std::uint8_t* bytes, std::size_t size,
                                                const Inspection& inspection);

/// Decides which packets that arrive at a participant's sockets it may be shown.
///
/// Knows the structure of RTPS 2.x messages (formal/22-04-01), of discovery and of what DDS
/// Security sends in the clear, and which participants speak from where. What is sealed by DDS
/// Security is checked for its length only. Pure: no I/O, no clock; `now` must not decrease by more
/// than the sender's lease. One thread at a time.
class RtpsFilter {
 public:
  explicit RtpsFilter(Limits limits);
  ~RtpsFilter();
  RtpsFilter(RtpsFilter&&) noexcept;
  RtpsFilter& operator=(RtpsFilter&&) noexcept;

  /// Takes a UDP payload that has arrived at `now`. An ordinary packet allocates nothing. Of a
  /// `sender` that is gone only the departure of a participant is believed: it is true.
  [[nodiscard]] Inspection inspect(const std::uint8_t* bytes, std::size_t size, Source from,
                                   Time now, Sender sender = Sender::trusted);
  /// Messages that the participant is to be shown at its port of discovery before the next packet,
  /// whoever has sent that: announcements of known participants, with another lease.
  [[nodiscard]] std::vector<std::vector<std::uint8_t>> take_due();
  /// A packet that jumps has cost the participant so much CPU time.
  void took(Duration cpu, Time now);
  /// DDS Security has found that a participant is who it says: from now on it is announced as it
  /// has been until then, and does not leave but by its silence. `prefix`: of its GUIDs.
  void authenticate(const std::array<std::uint8_t, 12>& prefix);
  /// Another instance has taken the participant's place. If nothing of it is received for 10 s it
  /// has left.
  void supersede(const std::array<std::uint8_t, 12>& prefix, Time now);
  /// The participant is not known to DDS any more: its next announcement is a stranger's.
  void forget(const std::array<std::uint8_t, 12>& prefix);
  /// Participants that are admitted now, the ones whose lease ran out unnoticed included.
  [[nodiscard]] std::size_t participants() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tocsin::rtps_filter
