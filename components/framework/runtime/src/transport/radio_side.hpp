// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fast_dds_v2/authentication_repeats.hpp"
#include "rtps/other_vendors.hpp"
#include "runtime/fast_dds/names.hpp"
#include "transport/guarded_transport.hpp"
#include "transport/radio_marks.hpp"
#include "transport/radio_ports.hpp"
#include "transport/stop_channel.hpp"

namespace tocsin {

/// What the packets of a router's participant have to do with.
struct RadioParts {
  std::shared_ptr<RadioMarks> marks;
  std::shared_ptr<OtherVendors> others;            ///< null: without DDS Security
  std::shared_ptr<AuthenticationRepeats> repeats;  ///< null: without DDS Security
  std::shared_ptr<StopChannel> stop;               ///< null: no emergency stop
  /// Where packets of its own go, by each path.
  std::vector<eprosima::fastdds::rtps::Locator_t> stop_peers;
  std::shared_ptr<RadioPorts> ports;  ///< by which it receives
};

/// UDP on the link: it sends through a socket of its own from `address`, each packet with the code
/// point that `marks` has for it, in RTPS messages of at most `radio_message_bytes`; it receives
/// any size. Heartbeats and acknowledgements of discovery are paced (DiscoveryPacer).
///
/// With `others` it is for a participant with DDS Security: Fast DDS makes messages as long as UDP
/// carries, and they go in pieces (MessagePieces); whole, so that IP divides them, to where
/// `others` are. What `stop` has to say rides in the packets, and goes alone where none follow.
[[nodiscard]] std::shared_ptr<TransportSide> radio_side(const std::string& address,
                                                        RadioParts parts);

}  // namespace tocsin
