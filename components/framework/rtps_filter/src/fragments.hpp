// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "submessages.hpp"

namespace tocsin::rtps_filter {

/// Announcements and messages of authentication are smaller.
inline constexpr std::uint32_t most_announcement_bytes = 64U << 10U;

/// Where a fragment was found, for the message that is made of all.
struct FragmentPlace {
  const std::uint8_t* packet;                 ///< begins with the RTPS header
  const std::uint8_t* destination = nullptr;  ///< the prefix of the last INFO_DST; null: none
};

/// Puts samples of discovery together from their fragments, so that they can be looked at before
/// Fast DDS, which would do so behind the filter, sees any of them.
class Fragments {
 public:
  /// Takes the fragments of a DATA_FRAG that `read_data_frag` has found sound. Returns an RTPS
  /// message with one DATA as soon as all of the sample is there. When more than a few samples are
  /// open, the oldest is forgotten; reliable writers send it again.
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> add(const Submessage& submessage,
                                                             const Data& data,
                                                             const FragmentPlace& place);
  /// Samples of which some fragments are missing.
  [[nodiscard]] std::size_t open() const { return open_.size(); }

 private:
  struct Sample {
    Prefix prefix;
    std::uint32_t writer = 0;
    std::int64_t number = 0;
    Data::Fragments shape;
    std::vector<bool> there;
    std::vector<std::uint8_t> payload;
    std::vector<std::uint8_t> inline_qos;
  };
  std::list<Sample>::iterator sample_of(const Data& data, const std::uint8_t* packet);
  static void store(Sample& sample, const Data& data);

  std::list<Sample> open_;  ///< the oldest first
};

}  // namespace tocsin::rtps_filter
