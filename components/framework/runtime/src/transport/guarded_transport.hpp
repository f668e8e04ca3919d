// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "fast_dds_v2/deferred_reception.hpp"
#include "runtime/fast_dds/transport.hpp"

namespace tocsin {

class HostMulticastReceiver;
class PacketFilter;
class RadioPorts;

/// What is particular to the transport of a participant on its host, or on the link.
class TransportSide {
 public:
  using Locator = eprosima::fastdds::rtps::Locator_t;
  using Sender = eprosima::fastdds::rtps::SenderResource;
  using Packet = std::pair<const std::uint8_t*, std::size_t>;

  virtual ~TransportSide() = default;
  /// Sends to all peers, whichever they are. Null when that cannot be now.
  [[nodiscard]] virtual std::unique_ptr<Sender> make_sender() = 0;
  /// The packet as the filter shall see it, in `changed` if it differs; of size zero when nothing
  /// is left of it.
  [[nodiscard]] virtual Packet received(const Packet& packet, const Locator& from,
                                        std::vector<std::uint8_t>& changed) = 0;
  /// Held while a packet that came to `local` is handed on.
  [[nodiscard]] virtual std::unique_lock<std::mutex> turn(const Locator& /*local*/) { return {}; }
  /// What receives in place of the transport below; null: nothing does.
  [[nodiscard]] virtual RadioPorts* ports() { return nullptr; }
  /// Where a sender is, as Fast DDS knows it.
  [[nodiscard]] virtual Locator known_as(const Locator& from) const { return from; }
  /// What receives multicast; null: nothing does.
  [[nodiscard]] virtual HostMulticastReceiver* group() { return nullptr; }
  /// Where packets for a peer's locator go; false: nowhere.
  [[nodiscard]] virtual bool reach(const Locator& remote, Locator& result) const = 0;
  /// Of RTPS messages that are sent.
  [[nodiscard]] virtual std::uint32_t message_bytes() const = 0;
};

/// UDP whose reception is held until `reception` is released, watched (Activity), and shows what
/// `filter` lets through. `side` null: it sends and finds peers as UDP of Fast DDS does.
struct GuardedTransportParts {
  std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp;
  std::shared_ptr<TransportSide> side;
  std::shared_ptr<DeferredReception> reception;
  std::shared_ptr<PacketFilter> filter;
};
[[nodiscard]] std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface>
guarded_transport(GuardedTransportParts parts);

}  // namespace tocsin
