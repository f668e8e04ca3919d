// SPDX-License-Identifier: Apache-2.0
#include "transport/host_side.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <optional>
#include <system_error>

#include "fast_dds_v2/acknack_counts.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "runtime/fast_dds/names.hpp"
#include "transport/host_multicast.hpp"
#include "transport/packet_filter.hpp"
#include "transport/udp_sockets.hpp"
#include "watch/activity.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using rtps::IPLocator;

const char* const loopback = "127.0.0.1";
constexpr std::uint32_t udp_message_bytes = 65500;

/// Sends to the peers and to the discovery group on loopback, and to the group also where another
/// program of this host has joined it.
class HostSender : public fast_dds::PacketSender {
 public:
  explicit HostSender(std::uint32_t socket_bytes) : loopback_(sole_udp_socket()) {
    const ip_mreqn lo{{}, {}, static_cast<int>(if_nametoindex("lo"))};
    if (::setsockopt(loopback_.get(), IPPROTO_IP, IP_MULTICAST_IF, &lo, sizeof lo) != 0) {
      throw EnvironmentError("no announcements on loopback: " +
                             std::generic_category().message(errno));
    }
    // The kernel may give less: a burst of large samples waits then.
    (void)::setsockopt(loopback_.get(), SOL_SOCKET, SO_SNDBUF, &socket_bytes, sizeof socket_bytes);
  }

 private:
  bool send_packet(const std::uint8_t* bytes, std::uint32_t size, rtps::LocatorsIterator& next,
                   const rtps::LocatorsIterator& last) override {
    bool all_sent = true;
    for (; next != last; ++next) {
      const rtps::Locator_t& to = *next;
      if (to.kind == LOCATOR_KIND_UDPv4) all_sent = send_to(bytes, size, to) && all_sent;
    }
    return all_sent;
  }
  bool send_to(const rtps::octet* bytes, std::uint32_t size, const rtps::Locator_t& to) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(IPLocator::getPhysicalPort(to));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);  // whatever it says: nothing leaves the host
    std::optional<ActivityTurn> turn;
    if (IPLocator::isMulticast(to)) {  // nothing but announcements goes by multicast
      turn.emplace(*timer_);
      inet_pton(AF_INET, discovery_group, &address.sin_addr);
      elsewhere_.send(bytes, size, IPLocator::getPhysicalPort(to));
    }
    return ::sendto(loopback_.get(), bytes, size, 0, reinterpret_cast<const sockaddr*>(&address),
                    sizeof address) == static_cast<ssize_t>(size);
  }

  const FileDescriptor loopback_;
  HostMulticastSender elsewhere_{loopback_};
  const std::shared_ptr<Activity> timer_ =
      watched_activity(Duty::announcements, "timer of the host's participant");
};

class HostSide final : public TransportSide {
 public:
  HostSide(std::uint16_t group_port, std::uint32_t socket_bytes)
      : port_(group_port), socket_bytes_(socket_bytes), group_(group_port) {}

  /// What Fast DDS sends from has not its port alone, see sole_udp_socket.
  [[nodiscard]] std::unique_ptr<Sender> make_sender() override {
    return std::make_unique<HostSender>(socket_bytes_);
  }
  [[nodiscard]] Packet received(const Packet& packet, const Locator& /*from*/,
                                std::vector<std::uint8_t>& changed) override {
    return counts_.translate(packet.first, packet.second, changed);
  }
  /// Announcements come by the group, what follows by unicast: who announces itself is not known
  /// yet while Fast DDS answers, and what it says then would be thrown away.
  [[nodiscard]] std::unique_lock<std::mutex> turn(const Locator& local) override {
    const bool discovers = PacketFilter::kind_of(local.port) == PacketFilter::Port::discovery;
    return discovers ? std::unique_lock<std::mutex>(discovery_) : std::unique_lock<std::mutex>();
  }
  [[nodiscard]] HostMulticastReceiver* group() override { return &group_; }
  /// Whom we hear is on this host, and whoever listens to an address of this host, listens to
  /// loopback. Peers are never sent to by multicast, since each listens to it on an interface of
  /// its choice only; the group of our own domain is for announcements.
  [[nodiscard]] bool reach(const Locator& remote, Locator& result) const override {
    if (remote.kind != LOCATOR_KIND_UDPv4) return false;
    result = remote;
    if (IPLocator::isMulticast(remote)) {
      return IPLocator::toIPv4string(remote) == discovery_group && remote.port == port_;
    }
    IPLocator::setIPv4(result, loopback);
    return true;
  }
  [[nodiscard]] std::uint32_t message_bytes() const override { return udp_message_bytes; }

 private:
  const std::uint16_t port_;
  const std::uint32_t socket_bytes_;
  HostMulticastReceiver group_;
  AckNackCounts counts_;
  std::mutex discovery_;
};

}  // namespace

std::shared_ptr<TransportSide> host_side(int domain, std::uint32_t socket_bytes) {
  return std::make_shared<HostSide>(discovery_group_port(domain), socket_bytes);
}

}  // namespace tocsin
