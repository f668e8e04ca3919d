// SPDX-License-Identifier: Apache-2.0
#include "watch/own_sockets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include "foundation/file_descriptor.hpp"
#include "transport/self_sender.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::Not;

TEST(OwnSockets, UdpOnly) {
  const SelfSender udp;
  const FileDescriptor tcp(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto found = own_udp_sockets();
  EXPECT_THAT(found, Contains(Field(&OwnSocket::descriptor, udp.socket().get())));
  EXPECT_THAT(found, Contains(Field(&OwnSocket::port, udp.port())));
  EXPECT_THAT(found, Not(Contains(Field(&OwnSocket::descriptor, tcp.get()))));
}

TEST(OwnSockets, BytesWaitUntilTheyAreRead) {
  SelfSender socket;
  EXPECT_THAT(unread_ports(), Not(Contains(socket.port())));
  socket.send();
  EXPECT_THAT(unread_ports(), Contains(socket.port()));
  socket.receive();
  EXPECT_THAT(unread_ports(), Not(Contains(socket.port())));
}

TEST(OwnSockets, AClosedOneIsNoMore) {
  std::uint16_t port = 0;
  {
    const SelfSender socket;
    port = socket.port();
  }
  EXPECT_THAT(own_udp_sockets(), Not(Contains(Field(&OwnSocket::port, port))));
}

}  // namespace
}  // namespace tocsin
