// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "discovery.hpp"

namespace tocsin::rtps_filter {

/// What the structure of a packet tells without memory of others.
struct Survey {
  Wrong wrong;
  bool needs_memory = false;  ///< it announces, or tells numbers of a writer
};
[[nodiscard]] Survey survey(const std::uint8_t* bytes, std::size_t size, const Header& header,
                            const Limits& limits);

/// Whether a message of sound structure says that its participants leave, and nothing else.
[[nodiscard]] bool says_goodbye(const std::uint8_t* bytes, std::size_t size,
                                const Context& context);

/// Whether a submessage lies between the seals of DDS Security, of which it is told one by one.
/// Fast DDS opens the seal of a whole message at its begin only.
class Seals {
 public:
  void pass(std::uint8_t kind) {
    if (kind == kind::srtps_prefix && first_) whole_ = true;
    if (kind == kind::sec_prefix) part_ = true;
    if (kind == kind::sec_postfix) part_ = false;
    first_ = false;
  }
  [[nodiscard]] bool sealed() const { return whole_ || part_; }

 private:
  bool first_ = true;
  bool whole_ = false;
  bool part_ = false;
};

}  // namespace tocsin::rtps_filter
