// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_ports.hpp"

#include <arpa/inet.h>
#include <pthread.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "transport/radio_socket.hpp"
#include "transport/socket_wait.hpp"
#include "transport/stop_channel.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

std::optional<rtps::Locator_t> moved(const std::map<std::uint32_t, std::uint32_t>& addresses,
                                     const rtps::Locator_t& from) {
  const auto found = addresses.find(ipv4_of(from));
  if (found == addresses.end()) return std::nullopt;
  rtps::Locator_t to = from;
  const in_addr address{htonl(found->second)};
  rtps::IPLocator::setIPv4(to, reinterpret_cast<const rtps::octet*>(&address));
  return to;
}

FileDescriptor opened(const std::string& address, std::uint16_t port) {
  FileDescriptor socket = radio_socket(address, port);
  if (socket) return socket;
  throw EnvironmentError(
      "UDP " + address + ":" + std::to_string(port) +
      ", a path over the link, cannot be listened to: " + std::generic_category().message(errno));
}

}  // namespace

/// A port of one path.
class RadioPorts::Port {
 public:
  Port(FileDescriptor socket, OnPacket on_packet)
      : socket_(std::move(socket)), on_packet_(std::move(on_packet)) {
    thread_ = std::thread([this] { run(); });
    pthread_setname_np(thread_.native_handle(), "radio_path");
  }
  ~Port() {
    stopping_ = true;
    (void)::shutdown(socket_.get(), SHUT_RD);  // wakes the thread
    thread_.join();
  }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

 private:
  void run() const {
    const SocketWait wait(socket_);
    receive_datagrams(socket_, stopping_,
                      [&](const std::uint8_t* bytes, std::size_t size, const sockaddr_in& from) {
                        on_packet_({bytes, size, from, wait.of_last()});
                      });
  }
  const FileDescriptor socket_;
  const OnPacket on_packet_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

RadioPorts::RadioPorts(const RadioPlace& place)
    : first_address_(place.first_address), second_address_(place.second_address) {
  const auto own = ipv4_addresses({place.first_address});
  if (!own.empty()) own_address_ = own.front();
  const auto firsts = ipv4_addresses(place.first_peers);
  const auto seconds = ipv4_addresses(place.second_peers);
  for (std::size_t i = 0; i < std::min(firsts.size(), seconds.size()); ++i) {
    seconds_[firsts[i]] = seconds[i];
    firsts_[seconds[i]] = firsts[i];
  }
}

RadioPorts::~RadioPorts() = default;

bool RadioPorts::claim(std::uint16_t port) {
  FileDescriptor socket = radio_socket(first_address_, port);
  if (!socket) return false;
  claimed_[port] = std::move(socket);
  own_port_ = port;
  return true;
}

bool RadioPorts::is_own(const Locator& place) const {
  const bool is_port = place.port == own_port_ || place.port == own_port_ + 1U;
  return is_port && ipv4_of(place) == own_address_;
}

void RadioPorts::start(std::uint16_t port, const OnPacket& on_packet) {
  auto& both = ports_[port];
  FileDescriptor claimed = std::move(claimed_[port]);
  claimed_.erase(port);
  both.push_back(std::make_unique<Port>(claimed ? std::move(claimed) : opened(first_address_, port),
                                        on_packet));
  if (second_address_.empty()) return;
  both.push_back(std::make_unique<Port>(opened(second_address_, port),
                                        [this, on_packet](const RadioPacket& packet) {
                                          if (is_second(ntohl(packet.from.sin_addr.s_addr)))
                                            on_packet(packet);
                                        }));
}

void RadioPorts::stop(std::uint16_t port) { ports_.erase(port); }

std::optional<RadioPorts::Locator> RadioPorts::second_of(const Locator& first) const {
  return moved(seconds_, first);
}

std::optional<RadioPorts::Locator> RadioPorts::first_of(const Locator& second) const {
  return moved(firsts_, second);
}

}  // namespace tocsin
