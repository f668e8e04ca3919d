// SPDX-License-Identifier: Apache-2.0
#include "transport/guarded_transport.hpp"

#include <arpa/inet.h>

#include <chrono>
#include <optional>

#include "fast_dds_v2/key_onlys.hpp"
#include "transport/host_multicast.hpp"
#include "transport/packet_filter.hpp"
#include "transport/radio_ports.hpp"
#include "transport/receptions.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using namespace eprosima::fastdds::rtps;

struct GuardedDescriptor : ChainingTransportDescriptor {
  explicit GuardedDescriptor(GuardedTransportParts its_parts)
      : ChainingTransportDescriptor(its_parts.udp), parts(std::move(its_parts)) {
    if (parts.side) maxMessageSize = parts.side->message_bytes();
  }
  [[nodiscard]] TransportInterface* create_transport() const override;
  [[nodiscard]] std::uint32_t max_message_size() const override { return maxMessageSize; }
  GuardedTransportParts parts;
};

rtps::Locator_t locator_of(const sockaddr_in& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  IPLocator::setIPv4(locator, reinterpret_cast<const rtps::octet*>(&address.sin_addr));
  locator.port = ntohs(address.sin_port);
  return locator;
}

std::uint16_t port_of(const rtps::Locator_t& at) { return static_cast<std::uint16_t>(at.port); }

/// Of a packet that has come.
struct Ends {
  rtps::Locator_t local;
  rtps::Locator_t remote;
};

/// Receives through the chain, or by ports of the radio, and sends without it.
class GuardedTransport : public fast_dds::PacketTransport {
 public:
  explicit GuardedTransport(GuardedDescriptor descriptor)
      : PacketTransport(descriptor), descriptor_(std::move(descriptor)) {}

  [[nodiscard]] TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool OpenInputChannel(const rtps::Locator_t& at, TransportReceiverInterface* receiver,
                        std::uint32_t largest) override;
  bool CloseInputChannel(const rtps::Locator_t& at) override;
  [[nodiscard]] bool IsInputChannelOpen(const rtps::Locator_t& at) const override;
  void receive(TransportReceiverInterface* next, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override;
  bool OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) override;

 private:
  [[nodiscard]] bool reach(const rtps::Locator_t& remote, rtps::Locator_t& result) const override {
    return side() != nullptr ? side()->reach(remote, result) : reach_below(remote, result);
  }
  [[nodiscard]] TransportSide* side() const { return descriptor_.parts.side.get(); }
  /// Null: not by multicast, or there is nothing that receives it.
  [[nodiscard]] HostMulticastReceiver* group_for(const rtps::Locator_t& at) const {
    return side() != nullptr && IPLocator::isMulticast(at) ? side()->group() : nullptr;
  }
  bool open(const rtps::Locator_t& at, TransportReceiverInterface* receiver, std::uint32_t largest);
  /// A packet that has waited in its socket for so long.
  void take(TransportReceiverInterface* next, TransportSide::Packet packet, const Ends& ends,
            Duration waited);
  /// Null: through the chain.
  [[nodiscard]] RadioPorts* ports() const { return side() != nullptr ? side()->ports() : nullptr; }
  void show(TransportReceiverInterface* next, const TransportSide::Packet& packet,
            const Ends& ends);

  GuardedDescriptor descriptor_;
  Receptions receptions_;
};

TransportInterface* GuardedDescriptor::create_transport() const {
  return new GuardedTransport(*this);
}

bool GuardedTransport::OpenInputChannel(const rtps::Locator_t& at,
                                        TransportReceiverInterface* receiver,
                                        std::uint32_t largest) {
  receptions_.open(at.port);
  const bool is_open = open(at, receiver, largest);
  is_open ? receptions_.opened(at.port) : receptions_.close(at.port);
  return is_open;
}

/// It receives messages that are longer than those that it sends.
bool GuardedTransport::open(const rtps::Locator_t& at, TransportReceiverInterface* receiver,
                            std::uint32_t largest) {
  if (ports() != nullptr) {
    ports()->start(port_of(at), [this, receiver, at](const RadioPacket& packet) {
      take(receiver, {packet.bytes, packet.size}, {at, locator_of(packet.from)}, packet.waited);
    });
    return true;
  }
  HostMulticastReceiver* const group = group_for(at);
  if (group == nullptr) {
    return ChainingTransport::OpenInputChannel(
        at, receiver, side() != nullptr ? descriptor_.parts.udp->maxMessageSize : largest);
  }
  group->start(
      [this, receiver, at](const std::uint8_t* bytes, std::size_t size, const sockaddr_in& from) {
        receive(receiver, bytes, static_cast<std::uint32_t>(size), at, locator_of(from));
      });
  return true;
}

bool GuardedTransport::CloseInputChannel(const rtps::Locator_t& at) {
  descriptor_.parts.reception->release();
  if (ports() != nullptr) {
    ports()->stop(port_of(at));
    receptions_.close(at.port);
    return true;
  }
  receptions_.close(at.port);
  HostMulticastReceiver* const group = group_for(at);
  if (group == nullptr) return ChainingTransport::CloseInputChannel(at);
  group->stop();
  return true;
}

bool GuardedTransport::IsInputChannelOpen(const rtps::Locator_t& at) const {
  if (ports() != nullptr) return ports()->is_open(port_of(at));
  const HostMulticastReceiver* const group = group_for(at);
  return group != nullptr ? group->is_running() : ChainingTransport::IsInputChannelOpen(at);
}

void GuardedTransport::receive(TransportReceiverInterface* next, const rtps::octet* bytes,
                               std::uint32_t size, const rtps::Locator_t& local,
                               const rtps::Locator_t& remote) {
  const Reception at = receptions_.at(local.port);
  take(next, {bytes, size}, {local, remote}, at.socket ? at.socket->of_last() : Duration{0});
}

void GuardedTransport::take(TransportReceiverInterface* next, TransportSide::Packet packet,
                            const Ends& ends, Duration waited) {
  std::unique_lock<std::mutex> turn;
  std::vector<std::uint8_t> changed;
  Ends known = ends;
  if (side() != nullptr) {
    turn = side()->turn(ends.local);
    packet = side()->received(packet, ends.remote, changed);
    if (packet.second == 0) return;
    known.remote = side()->known_as(ends.remote);
  }
  const HandingOn handing_on(waited);
  std::optional<ActivityTurn> seen;
  if (const auto activity = receptions_.at(ends.local.port).activity) seen.emplace(*activity);
  descriptor_.parts.reception->wait();
  show(next, packet, known);
}

void GuardedTransport::show(TransportReceiverInterface* next, const TransportSide::Packet& packet,
                            const Ends& ends) {
  std::vector<std::uint8_t> changed;
  descriptor_.parts.filter->pass(
      packet.first, packet.second, ends.remote, PacketFilter::kind_of(ends.local.port),
      [&](const rtps::octet* shown, std::size_t length) {
        const auto [message, size] = with_key_onlys(shown, length, changed);
        next->OnDataReceived(message, static_cast<std::uint32_t>(size), ends.local, ends.remote);
      });
}

/// Not chained: Fast DDS would not know its own channel again, and open another for each peer. One
/// sender reaches all.
bool GuardedTransport::OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) {
  if (side() == nullptr) return low_level_transport_->OpenOutputChannel(channels, to);
  if (to.kind != LOCATOR_KIND_UDPv4) return false;
  if (!channels.empty()) return true;
  auto sender = side()->make_sender();
  if (!sender) return false;
  channels.push_back(std::move(sender));
  return true;
}

}  // namespace

std::shared_ptr<TransportDescriptorInterface> guarded_transport(GuardedTransportParts parts) {
  return std::make_shared<GuardedDescriptor>(std::move(parts));
}

}  // namespace tocsin
