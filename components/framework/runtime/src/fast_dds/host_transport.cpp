// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/host_transport.hpp"

#include <arpa/inet.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPFinder.h>
#include <fastrtps/utils/IPLocator.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "fast_dds/acknack_counts.hpp"
#include "fast_dds/host_multicast.hpp"
#include "fast_dds/udp_sockets.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "watch/activity.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using namespace eprosima::fastdds::rtps;
using Deadline = std::chrono::steady_clock::time_point;
using rtps::IPLocator;

const char* const loopback = "127.0.0.1";

/// Sends to the peers and to the discovery group on loopback, and to the group also where another
/// program of this host has joined it.
class HostSender : public rtps::SenderResource {
 public:
  explicit HostSender(std::uint32_t socket_bytes)
      : SenderResource(LOCATOR_KIND_UDPv4), loopback_(sole_udp_socket()) {
    const ip_mreqn lo{{}, {}, static_cast<int>(if_nametoindex("lo"))};
    if (::setsockopt(loopback_.get(), IPPROTO_IP, IP_MULTICAST_IF, &lo, sizeof lo) != 0) {
      throw EnvironmentError("no announcements on loopback: " +
                             std::generic_category().message(errno));
    }
    // The kernel may give less: a burst of large samples waits then.
    (void)::setsockopt(loopback_.get(), SOL_SOCKET, SO_SNDBUF, &socket_bytes, sizeof socket_bytes);
    send_lambda_ = [this](const rtps::octet* bytes, std::uint32_t size,
                          rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
                          const Deadline&) {
      bool all_sent = true;
      for (; *first != *last; ++*first) {
        const rtps::Locator_t& to = **first;
        if (to.kind == LOCATOR_KIND_UDPv4) all_sent = send(bytes, size, to) && all_sent;
      }
      return all_sent;
    };
  }

 private:
  bool send(const rtps::octet* bytes, std::uint32_t size, const rtps::Locator_t& to) {
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

struct HostDescriptor : ChainingTransportDescriptor {
  HostDescriptor(const std::shared_ptr<UDPv4TransportDescriptor>& low, std::uint16_t group_port)
      : ChainingTransportDescriptor(low),
        port(group_port),
        socket_bytes(low->sendBufferSize),
        group(std::make_shared<HostMulticastReceiver>(group_port)) {}
  [[nodiscard]] TransportInterface* create_transport() const override;
  std::uint16_t port;
  std::uint32_t socket_bytes;
  std::shared_ptr<HostMulticastReceiver> group;
};

class HostTransport : public ChainingTransport {
 public:
  explicit HostTransport(HostDescriptor descriptor)
      : ChainingTransport(descriptor), descriptor_(std::move(descriptor)) {}

  [[nodiscard]] TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool OpenInputChannel(const rtps::Locator_t& at, TransportReceiverInterface* receiver,
                        std::uint32_t largest) override;
  bool CloseInputChannel(const rtps::Locator_t& at) override;
  [[nodiscard]] bool IsInputChannelOpen(const rtps::Locator_t& at) const override {
    return IPLocator::isMulticast(at) ? descriptor_.group->is_running()
                                      : ChainingTransport::IsInputChannelOpen(at);
  }
  /// Whom we hear is on this host, and whoever listens to an address of this host, listens to
  /// loopback. Peers are never sent to by multicast, since each listens to it on an interface of
  /// its choice only; the group of our own domain is for announcements.
  bool transform_remote_locator(const rtps::Locator_t& remote,
                                rtps::Locator_t& result) const override;
  void receive(TransportReceiverInterface* next, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override;
  bool OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) override;
  // NOLINTNEXTLINE(readability-function-size): the signature is that of Fast DDS
  bool send(rtps::SenderResource* channel, const rtps::octet* bytes, std::uint32_t size,
            rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const Deadline& deadline) override {
    return channel->send(bytes, size, first, last, deadline);
  }

 private:
  HostDescriptor descriptor_;
  AckNackCounts counts_;
  /// Announcements come by the group, what follows by unicast: who announces itself is not known
  /// yet while Fast DDS answers, and what it says then would be thrown away.
  std::mutex discovery_;
};

TransportInterface* HostDescriptor::create_transport() const { return new HostTransport(*this); }

/// Ports for discovery are even, those for samples odd (RTPS 2.2 section 9.6.1.1).
bool is_for_discovery(const rtps::Locator_t& local) { return local.port % 2 == 0; }

rtps::Locator_t locator_of(const sockaddr_in& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  IPLocator::setIPv4(locator, reinterpret_cast<const rtps::octet*>(&address.sin_addr));
  locator.port = ntohs(address.sin_port);
  return locator;
}

bool HostTransport::OpenInputChannel(const rtps::Locator_t& at,
                                     TransportReceiverInterface* receiver, std::uint32_t largest) {
  if (!IPLocator::isMulticast(at)) {
    return ChainingTransport::OpenInputChannel(at, receiver, largest);
  }
  descriptor_.group->start(
      [this, receiver, at](const std::uint8_t* bytes, std::size_t size, const sockaddr_in& from) {
        receive(receiver, bytes, static_cast<std::uint32_t>(size), at, locator_of(from));
      });
  return true;
}

bool HostTransport::CloseInputChannel(const rtps::Locator_t& at) {
  if (!IPLocator::isMulticast(at)) return ChainingTransport::CloseInputChannel(at);
  descriptor_.group->stop();
  return true;
}

bool HostTransport::transform_remote_locator(const rtps::Locator_t& remote,
                                             rtps::Locator_t& result) const {
  if (remote.kind != LOCATOR_KIND_UDPv4) return false;
  result = remote;
  if (IPLocator::isMulticast(remote)) {
    return IPLocator::toIPv4string(remote) == discovery_group && remote.port == descriptor_.port;
  }
  IPLocator::setIPv4(result, loopback);
  return true;
}

void HostTransport::receive(TransportReceiverInterface* next, const rtps::octet* bytes,
                            std::uint32_t size, const rtps::Locator_t& local,
                            const rtps::Locator_t& remote) {
  std::unique_lock<std::mutex> turn(discovery_, std::defer_lock);
  if (is_for_discovery(local)) turn.lock();
  std::vector<std::uint8_t> changed;
  const auto message = counts_.translate(bytes, size, changed);
  next->OnDataReceived(message.first, static_cast<std::uint32_t>(message.second), local, remote);
}

/// Not chained: what the lower transport sends from has not its port alone, see sole_udp_socket.
bool HostTransport::OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) {
  if (to.kind != LOCATOR_KIND_UDPv4) return false;
  const bool there = std::any_of(channels.begin(), channels.end(), [](const auto& one) {
    return dynamic_cast<const HostSender*>(one.get()) != nullptr;
  });
  if (!there) channels.push_back(std::make_unique<HostSender>(descriptor_.socket_bytes));
  return true;
}

}  // namespace

std::shared_ptr<TransportDescriptorInterface> host_transport(int domain,
                                                             std::uint32_t socket_bytes) {
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {loopback};
  udp->sendBufferSize = socket_bytes;
  udp->receiveBufferSize = socket_bytes;
  return std::make_shared<HostDescriptor>(std::move(udp), discovery_group_port(domain));
}

}  // namespace tocsin
