// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tocsin::rtps_filter {

/// Why a packet is kept from a participant. The README says of each which rule of the standard it
/// breaks, or what it would do to Fast DDS.
enum class DropReason : std::uint8_t {
  not_rtps,                ///< no RTPS header of version 2
  submessage_length,       ///< a submessage is longer than the packet, or shorter than its kind
  vendor_submessage,       ///< Fast DDS's statistics submessage in another form than its own
  inline_qos_offset,       ///< octetsToInlineQos points into the header or beyond the submessage
  parameter_length,        ///< a parameter list ends beyond its place, or has no sentinel
  parameter_content,       ///< a string, sequence or value does not fit into its parameter
  security_content,        ///< a token or a message of authentication of no valid form
  sequence_number,         ///< a number or set of numbers that cannot be
  gap_range,               ///< a GAP over more numbers than a reader can walk
  sequence_jump,           ///< a HEARTBEAT far beyond what its reader was told
  fragment,                ///< fragment numbers or sizes that do not fit together
  sample_size,             ///< fragments of a sample larger than any topic's
  payload,                 ///< a payload without a header of a known encoding
  discovery_payload,       ///< discovery of no valid form
  foreign_identity,        ///< speaks for another participant than its sender
  forged_source,           ///< a known participant's name from another address
  forged_disposal,         ///< says that a participant has left, from another address
  unknown_source,          ///< comes from an address that the configuration does not name
  other_user,              ///< comes from a socket of another user of this computer
  closed_socket,           ///< comes from a socket of this computer that nobody has any more
  too_many_participants,   ///< more participants than are admitted
  too_many_endpoints,      ///< more endpoints than are admitted
  too_many_announcements,  ///< more discovery a second than a source may send
  too_many_bytes,          ///< more bytes a second than a source may send
  unsealed,                ///< DDS Security would have sealed it
  unauthenticated,  ///< without a seal, other news of a participant that has proved who it is
};

inline constexpr std::size_t drop_reasons = 26;

/// The enumerator's name, as in diagnostics and logs.
[[nodiscard]] std::string_view to_text(DropReason reason);

}  // namespace tocsin::rtps_filter
