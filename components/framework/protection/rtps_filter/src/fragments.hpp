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

/// In which packet a submessage stands, and for whom.
struct Place {
  const std::uint8_t* packet;                 ///< begins with the RTPS header
  const std::uint8_t* destination = nullptr;  ///< the prefix of the last INFO_DST; null: none
};

/// What becomes of a fragment.
struct FragmentFate {
  bool hide = true;
  /// An RTPS message with one DATA, as soon as all of the sample is there.
  std::optional<std::vector<std::uint8_t>> whole;
};

/// Puts samples of discovery together from their fragments, so that they can be looked at before
/// Fast DDS, which would do so behind the filter, has all of them.
class Fragments {
 public:
  enum class Rule {
    /// Fragments are never shown. Of many open samples the oldest is forgotten.
    hide_all,
    /// All are shown but the one that completes a sample, so that the reader asks for the rest:
    /// Cyclone DDS repeats only the first of a sample unasked. What has been shown is remembered
    /// for as long as the reader may remember it.
    hide_last,
  };
  explicit Fragments(Rule rule) : rule_(rule) {}

  /// Takes the fragments of a DATA_FRAG that `read_data_frag` has found sound.
  [[nodiscard]] FragmentFate add(const Submessage& submessage, const Data& data,
                                 const Place& place);
  /// The whole of the sample that was completed last was good, and its reader has it.
  void close() { open_.pop_back(); }
  /// Forgets samples of others than these.
  template <class IsKnown>
  void keep(IsKnown is_known) {
    open_.remove_if([&](const Sample& sample) { return !is_known(sample.prefix); });
  }
  /// No room for another sample under `hide_last`.
  [[nodiscard]] bool full() const;

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
  using Samples = std::list<Sample>;
  /// The end when there is no room.
  Samples::iterator sample_of(const Data& data, const std::uint8_t* packet);
  static void store(Sample& sample, const Data& data);

  const Rule rule_;
  Samples open_;  ///< the oldest first
};

/// The DATA message `whole`, of which `fragment` was a part, as one DATA_FRAG with all fragments.
[[nodiscard]] std::vector<std::uint8_t> as_fragments(const std::vector<std::uint8_t>& whole,
                                                     const Data::Fragments& fragment);

}  // namespace tocsin::rtps_filter
