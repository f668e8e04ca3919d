// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "discovery.hpp"
#include "rtps_filter/rtps_filter.hpp"

namespace tocsin::rtps_filter {

using Octets = std::vector<std::uint8_t>;

/// A participant's announcement as Fast DDS was shown it, to be shown again with another lease.
class AnnouncementCopy {
 public:
  AnnouncementCopy() = default;
  /// `submessage`: the DATA. `edits`: what of the packet is stripped and patched.
  AnnouncementCopy(const Submessage& submessage, const Announcement& what, const Context& context,
                   const Inspection& edits);

  /// Whether it says a lease, so that another can take its place.
  [[nodiscard]] bool has_lease() const { return lease_at_ != 0; }
  /// A message with this one DATA. Fast DDS ignores a number that is not above all before.
  [[nodiscard]] Octets with(Duration lease, std::int64_t number) const;

 private:
  Octets message_;
  std::size_t lease_at_ = 0;
  bool lease_is_little_ = true;
};

/// A message that says that a participant leaves. Fast DDS needs a number above all before.
[[nodiscard]] Octets departure_of(const Prefix& prefix, std::int64_t number);

/// Where in a packet the number of a DATA stands.
[[nodiscard]] std::size_t number_place(const Submessage& submessage, const std::uint8_t* packet);

}  // namespace tocsin::rtps_filter
