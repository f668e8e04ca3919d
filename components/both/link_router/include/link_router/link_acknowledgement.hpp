// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "foundation/link_path.hpp"
#include "link_router/transmission.hpp"

namespace tocsin::router {

/// What was received of one stream.
struct StreamAcknowledgement {
  static constexpr unsigned window = 64;
  StreamId stream = 0;
  TransmissionNumber highest = 0;  ///< the highest number received
  Duration age{0};                 ///< [>= 0] since its arrival, when the acknowledgement was made
  std::uint64_t before = 0;        ///< bit i: number highest - 1 - i was received, too
  PathIndex path = 0;              ///< of which these numbers are
};

/// What a router has received of one peer. It goes to that peer about ten times a second while
/// something is received; the clocks of the two need not agree.
///
/// A stream is in it when something of it was received, and again in later acknowledgements for a
/// while, so that a lost acknowledgement loses nothing. Of the clocks only differences are used.
/// Coded with 32 bits for numbers and 16 for ages in units of 100 us it takes 24 bytes and 18 a
/// stream.
struct LinkAcknowledgement {
  std::uint32_t count = 0;  ///< rises by 1 with each acknowledgement to this instance of the peer
  Time made{};              ///< by the clock of who made it
  std::vector<StreamAcknowledgement> streams;
};

}  // namespace tocsin::router
