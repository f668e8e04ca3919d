// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/file_descriptor.hpp"

namespace tocsin::foxglove {

struct Listening {
  FileDescriptor socket;  ///< of TCP; none: see `fault`
  int port = 0;
  bool inherited = false;
  std::string fault = {};  ///< why there is none
};

/// A socket that listens at an IPv4 or IPv6 address. One that this process was started with for the
/// same address and port is taken first: `tocsin launch` makes it outside of the host's emulated
/// network, systemd before the service starts. `port` 0: a free one.
[[nodiscard]] Listening open_listening_socket(const std::string& address, int port);

}  // namespace tocsin::foxglove
