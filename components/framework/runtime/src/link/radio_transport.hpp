// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/common/EntityId_t.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "link/message_pieces.hpp"
#include "link/other_makers.hpp"
#include "link/stop_channel.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/link_limits.hpp"

namespace tocsin {

/// Which differentiated services code point (RFC 2474) the packets of an endpoint bear, and how
/// many were sent. Discovery and what is not known bear CS6: little, and all else depends on it.
/// Thread-safe.
class RadioMarks {
 public:
  static constexpr int network_control = 48;  ///< CS6 (RFC 4594 section 3.1)

  /// `dscp` [0, 63]. Its bytes are counted for the class.
  void set(const eprosima::fastrtps::rtps::EntityId_t& endpoint, int dscp,
           TrafficClass traffic_class);
  void forget(const eprosima::fastrtps::rtps::EntityId_t& endpoint);
  /// Notes a packet of `sent` bytes, with the message or a piece of it, and returns its code point.
  [[nodiscard]] int mark(const std::uint8_t* message, std::size_t size, std::size_t sent);
  /// The same for a packet that holds a value of the emergency stop alone.
  [[nodiscard]] int mark_stop(std::size_t sent);
  [[nodiscard]] LinkPackets packets() const;

 private:
  using Endpoint = eprosima::fastrtps::rtps::EntityId_t;
  mutable std::mutex mutex_;
  struct Mark {
    int dscp;
    TrafficClass traffic_class;
  };
  std::map<Endpoint, Mark> marks_;
  LinkPackets packets_;
};

/// The stop's way out of a transport.
struct StopWay {
  std::shared_ptr<StopChannel> channel;
  std::vector<eprosima::fastrtps::rtps::Locator_t> peers;  ///< where packets of its own go
};

/// A UDP transport that sends through a socket of its own, each packet with the code point that
/// `marks` has for it, in RTPS messages of at most `radio_message_bytes`; it receives any size.
/// Heartbeats and acknowledgements of discovery are paced (DiscoveryPacer). With `others` it is for
/// a participant with DDS Security: Fast DDS
/// makes messages as long as UDP carries, and they go in pieces (MessagePieces); whole, so that IP
/// divides them, to where `others` are. What `stop` has to say rides in the packets, and goes alone
/// where none follow.
[[nodiscard]] std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> marked(
    std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp,
    std::shared_ptr<RadioMarks> marks, std::shared_ptr<OtherMakers> others, StopWay stop);

}  // namespace tocsin
