// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "foundation/time.hpp"

namespace tocsin::rtps_filter {

/// So much at once, and so much a second after that.
struct Rate {
  double burst = 0;
  double per_s = 0;
};

/// What a participant is shown. The defaults hold for a participant on the host's loopback; a
/// packet of any size is let through by itself.
struct Limits {
  std::uint32_t sample_bytes = 64U << 20U;  ///< largest sample that may come in fragments
  std::uint64_t gap_numbers = 1U << 20U;    ///< sequence numbers that one GAP may cover
  /// Sequence numbers by which the first of one HEARTBEAT may be ahead of what its reader was told;
  /// one that is further ahead becomes a step of so many. Fast DDS walks from one number to the
  /// next, 0.1 to 2 us each, and the reception of that port stands still meanwhile.
  std::int64_t jump_step = 1U << 20U;
  /// CPU time [s] that HEARTBEATs may cost which are more than `jump_free` numbers ahead
  /// (RtpsFilter::took). Those of a reader that has heard them all cost microseconds.
  Rate jump_cpu_s{4, 0.25};
  std::int64_t jump_free = 256;
  /// Sequence numbers in a participant's GAPs. Fast DDS keeps 48 bytes for each that lies beyond a
  /// hole.
  Rate gap_rate{1'048'576, 65'536};
  /// Of these, numbers in all GAPs of all participants that may lie beyond a hole.
  Rate kept_numbers{524'288, 32'768};
  /// Bytes of samples that have begun in fragments, less those of the fragments that came since.
  /// Fast DDS takes memory for the whole at the first one.
  Rate unfinished_bytes{32U << 20U, 1U << 20U};
  Rate announcements{4096, 512};  ///< of participants and endpoints, by a source
  Rate bytes{0, 0};               ///< by a source; burst 0: any number
  /// Admitted at the same time; about 5 kB each, and 0.1 % of a core, as each is told twice a
  /// second that we are there.
  std::size_t participants = 128;
  /// Where as many are there, a newcomer takes the place of the one that has been silent longest,
  /// for so long at least; zero: only of one whose lease is over.
  Duration yields_after{};
  Duration longest_lease{};  ///< a longer one is shown as this; zero: any
  /// A departure is shown as a lease of so long, so that only silence confirms it; zero: at once.
  Duration departure_wait{};
  std::size_t endpoints = 16'384;        ///< of all participants; about 3 kB each
  std::size_t sources = 1024;            ///< kept account of at the same time
  bool source_has_port = true;           ///< sources of one address and several ports are several
  bool participant_has_address = false;  ///< all that a participant sends comes from one address
  bool strip_type_information = true;    ///< take what announcements tell of the layout of types
  /// Protected submessages were sealed by their sender and must not be changed, and what is to be
  /// sealed is dropped without a seal. Only where the participant has DDS Security: others read
  /// what stands between the seals.
  bool secured = false;
  /// Whether packets of this address are heard at all; empty: of any.
  std::function<bool(std::uint32_t address)> hears = {};
  /// Whether a locator of this address may be answered; empty: any.
  std::function<bool(std::uint32_t address)> answers = {};
  /// Whether a participant with this user data is to be found; empty: any. Announcements of others
  /// are hidden, and not counted as dropped.
  std::function<bool(std::string_view user_data)> finds = {};
};

}  // namespace tocsin::rtps_filter
