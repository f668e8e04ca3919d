// SPDX-License-Identifier: Apache-2.0
#include "transport/sender_users.hpp"

#include <unistd.h>

#include <algorithm>

#include "runtime/logger.hpp"

namespace tocsin {

using rtps_filter::Sender;

Sender sender_among(const UdpSockets::Found& sockets, uid_t own) {
  if (sockets.empty()) return Sender::gone;
  const bool all_trusted = std::all_of(sockets.begin(), sockets.end(), [own](const UdpSocket& one) {
    return one.user == own || one.user == 0;
  });
  return all_trusted ? Sender::trusted : Sender::other;
}

SenderUsers::SenderUsers() : own_(::geteuid()), can_tell_(sockets_.answers()) {
  static std::once_flag said;
  if (can_tell_) return;
  std::call_once(said, [] {
    Logger("dds").warn(
        "the kernel does not tell whose UDP sockets are (udp_diag, AF_NETLINK): every user of this "
        "computer is heard on its host domain");
  });
}

Sender SenderUsers::sender(const rtps_filter::Source& from) {
  if (!can_tell_) return Sender::trusted;
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(from.address);
  place.sin_port = htons(from.port);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto visible = sockets_.at(place);
  if (!visible) return Sender::other;
  const Sender sender = sender_among(*visible, own_);
  if (sender != Sender::trusted || visible->front().is_sole) return sender;
  const auto all = sockets_.with_port(from.port);
  return all ? sender_among(*all, own_) : Sender::other;
}

}  // namespace tocsin
