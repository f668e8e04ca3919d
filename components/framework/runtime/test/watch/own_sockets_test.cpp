// SPDX-License-Identifier: Apache-2.0
#include "watch/own_sockets.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include "foundation/file_descriptor.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::Not;

sockaddr_in place_of(const FileDescriptor& socket) {
  sockaddr_in at{};
  socklen_t size = sizeof at;
  EXPECT_EQ(::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&at), &size), 0);
  return at;
}

FileDescriptor bound_socket(int type) {
  FileDescriptor socket(::socket(AF_INET, type | SOCK_CLOEXEC, 0));
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  return socket;
}

TEST(OwnSockets, UdpOnly) {
  const FileDescriptor udp = bound_socket(SOCK_DGRAM);
  const FileDescriptor tcp = bound_socket(SOCK_STREAM);
  const auto found = own_udp_sockets();
  EXPECT_THAT(found, Contains(Field(&OwnSocket::descriptor, udp.get())));
  EXPECT_THAT(found, Contains(Field(&OwnSocket::port, ntohs(place_of(udp).sin_port))));
  EXPECT_THAT(found, Not(Contains(Field(&OwnSocket::descriptor, tcp.get()))));
}

TEST(OwnSockets, BytesWaitUntilTheyAreRead) {
  const FileDescriptor socket = bound_socket(SOCK_DGRAM);
  const sockaddr_in at = place_of(socket);
  const std::uint16_t port = ntohs(at.sin_port);
  EXPECT_THAT(unread_ports(), Not(Contains(port)));
  ASSERT_EQ(::sendto(socket.get(), "ab", 2, 0, reinterpret_cast<const sockaddr*>(&at), sizeof at),
            2);
  EXPECT_THAT(unread_ports(), Contains(port));
  char bytes[2];
  ASSERT_EQ(::recv(socket.get(), bytes, sizeof bytes, 0), 2);
  EXPECT_THAT(unread_ports(), Not(Contains(port)));
}

TEST(OwnSockets, AClosedOneIsNoMore) {
  std::uint16_t port = 0;
  {
    const FileDescriptor socket = bound_socket(SOCK_DGRAM);
    port = ntohs(place_of(socket).sin_port);
  }
  EXPECT_THAT(own_udp_sockets(), Not(Contains(Field(&OwnSocket::port, port))));
}

}  // namespace
}  // namespace tocsin
