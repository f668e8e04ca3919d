// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <set>

namespace tocsin {

/// Ports of those UDP sockets in a text like /proc/net/udp in which bytes wait, and whose inode is
/// among `inodes`. A line that is none of such a text says nothing.
[[nodiscard]] std::set<std::uint16_t> unread_ports(std::istream& text,
                                                   const std::set<std::uint64_t>& inodes);

/// The same for this process and the kernel's text.
[[nodiscard]] std::set<std::uint16_t> unread_ports();

}  // namespace tocsin
