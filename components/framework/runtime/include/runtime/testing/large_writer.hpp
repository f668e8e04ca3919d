// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// Somebody on a link who is no router: what he writes is not cut to the size of a radio packet.
struct LargeWriter {
  int domain = 0;
  std::string address;  ///< own IPv4 on the link
  std::string peer;     ///< IPv4 of who hears it
  std::string topic;    ///< on the wire, of std_msgs/msg/String
};

/// Writes a text of `bytes` each `period`, each in one datagram, for ever. Throws EnvironmentError
/// when the participant cannot be created.
[[noreturn]] void write_large(const LargeWriter& writer, std::size_t bytes, Duration period);

}  // namespace tocsin
