// SPDX-License-Identifier: Apache-2.0
#include "transport/second_radio.hpp"

#include <arpa/inet.h>
#include <fastrtps/utils/IPLocator.h>
#include <pthread.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "foundation/error.hpp"
#include "transport/radio_socket.hpp"
#include "transport/stop_channel.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
constexpr std::size_t datagram_room = 65'536;

std::optional<rtps::Locator_t> moved(const std::map<std::uint32_t, std::uint32_t>& addresses,
                                     const rtps::Locator_t& from) {
  const auto found = addresses.find(ipv4_of(from));
  if (found == addresses.end()) return std::nullopt;
  rtps::Locator_t to = from;
  const in_addr address{htonl(found->second)};
  rtps::IPLocator::setIPv4(to, reinterpret_cast<const rtps::octet*>(&address));
  return to;
}

}  // namespace

SecondRadio::SecondRadio(const SecondRadioPlace& place) : address_(place.address) {
  const auto firsts = ipv4_addresses(place.first_peers);
  const auto seconds = ipv4_addresses(place.peers);
  for (std::size_t i = 0; i < std::min(firsts.size(), seconds.size()); ++i) {
    seconds_[firsts[i]] = seconds[i];
    firsts_[seconds[i]] = firsts[i];
  }
}

SecondRadio::~SecondRadio() {
  while (!ports_.empty()) stop(ports_.begin()->first);
}

void SecondRadio::start(std::uint16_t number, OnDatagram on_datagram) {
  auto port = std::make_unique<Port>();
  port->socket = radio_socket(address_, number, true);
  if (!port->socket) {
    throw EnvironmentError("UDP " + address_ + ":" + std::to_string(number) +
                           ", the second path over the link, cannot be listened to: " +
                           std::generic_category().message(errno));
  }
  port->thread = std::thread([&port = *port, heard = std::move(on_datagram)] { run(port, heard); });
  pthread_setname_np(port->thread.native_handle(), "second_radio");
  ports_[number] = std::move(port);
}

void SecondRadio::stop(std::uint16_t number) {
  const auto found = ports_.find(number);
  if (found == ports_.end()) return;
  Port& port = *found->second;
  port.stopping = true;
  (void)::shutdown(port.socket.get(), SHUT_RD);  // wakes the thread
  port.thread.join();
  ports_.erase(found);
}

void SecondRadio::run(const Port& port, const OnDatagram& on_datagram) {
  std::vector<std::uint8_t> bytes(datagram_room);
  while (!port.stopping) {
    sockaddr_in from{};
    socklen_t from_size = sizeof from;
    const ssize_t size = ::recvfrom(port.socket.get(), bytes.data(), bytes.size(), 0,
                                    reinterpret_cast<sockaddr*>(&from), &from_size);
    if (size > 0) on_datagram(bytes.data(), static_cast<std::size_t>(size), from);
  }
}

std::optional<SecondRadio::Locator> SecondRadio::second_of(const Locator& first) const {
  return moved(seconds_, first);
}

std::optional<SecondRadio::Locator> SecondRadio::first_of(const Locator& second) const {
  return moved(firsts_, second);
}

}  // namespace tocsin
