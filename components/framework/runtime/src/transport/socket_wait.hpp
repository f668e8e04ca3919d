// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "foundation/file_descriptor.hpp"
#include "foundation/time.hpp"

namespace tocsin {

/// Tells how long the packets of a UDP socket of this process waited in it until they were read: a
/// process that was stopped for a while finds old ones there, which nothing in them gives away
/// where clocks differ. The kernel notes when each came (SIOCGSTAMPNS, socket(7)).
class SocketWait {
 public:
  /// The socket must be open by then, and stays so as long as this is asked.
  explicit SocketWait(std::uint16_t port);
  explicit SocketWait(const FileDescriptor& socket);
  /// Of the packet that was read last; to be asked by who read it. Zero where that is not known.
  [[nodiscard]] Duration of_last() const;

 private:
  int socket_ = -1;  ///< not ours to close
};

/// How long the packet waited that this thread of Fast DDS hands on just now. Zero for others.
[[nodiscard]] Duration waited_in_socket();

/// Makes waited_in_socket say so for as long as it lives.
class HandingOn {
 public:
  explicit HandingOn(Duration waited);
  ~HandingOn();
  HandingOn(const HandingOn&) = delete;
  HandingOn& operator=(const HandingOn&) = delete;
};

}  // namespace tocsin
