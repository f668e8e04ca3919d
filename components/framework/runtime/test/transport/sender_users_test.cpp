// SPDX-License-Identifier: Apache-2.0
// Real sockets on loopback, some of another user.
#include "transport/sender_users.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "fast_dds/other_user.hpp"

namespace tocsin {
namespace {

using rtps_filter::Sender;
using rtps_filter::Source;

constexpr std::uint32_t loopback = 0x7f000001;
constexpr std::uint32_t other_loopback = 0x7f000002;

sockaddr_in place(std::uint32_t address, std::uint16_t port) {
  sockaddr_in made{};
  made.sin_family = AF_INET;
  made.sin_addr.s_addr = htonl(address);
  made.sin_port = htons(port);
  return made;
}

/// 0, or the error.
int bind_to(const FileDescriptor& socket, const sockaddr_in& at) {
  return ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0 ? 0 : errno;
}

FileDescriptor plain_socket() { return FileDescriptor(::socket(AF_INET, SOCK_DGRAM, 0)); }

FileDescriptor socket_at(std::uint32_t address, std::uint16_t port = 0) {
  FileDescriptor made = plain_socket();
  EXPECT_EQ(bind_to(made, place(address, port)), 0);
  return made;
}

std::uint16_t port_of(const FileDescriptor& socket) {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  EXPECT_EQ(::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&own), &size), 0);
  return ntohs(own.sin_port);
}

Source source_of(const FileDescriptor& socket) { return {loopback, port_of(socket)}; }

/// Sends as if from `from`, which the socket need not be bound to.
bool send_as(const FileDescriptor& socket, const sockaddr_in& from, const sockaddr_in& to) {
  char letter = 'x';
  iovec content{&letter, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(in_pktinfo))> control{};
  msghdr message{};
  message.msg_name = const_cast<sockaddr_in*>(&to);
  message.msg_namelen = sizeof to;
  message.msg_iov = &content;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = IPPROTO_IP;
  header->cmsg_type = IP_PKTINFO;
  header->cmsg_len = CMSG_LEN(sizeof(in_pktinfo));
  in_pktinfo info{};
  info.ipi_spec_dst = from.sin_addr;
  std::memcpy(CMSG_DATA(header), &info, sizeof info);
  return ::sendmsg(socket.get(), &message, 0) == 1;
}

/// Where the datagram that waits came from.
Source source_of_next(const FileDescriptor& receiver) {
  sockaddr_in from{};
  socklen_t size = sizeof from;
  char letter = 0;
  EXPECT_EQ(::recvfrom(receiver.get(), &letter, 1, MSG_DONTWAIT, reinterpret_cast<sockaddr*>(&from),
                       &size),
            1);
  return {ntohl(from.sin_addr.s_addr), ntohs(from.sin_port)};
}

TEST(SenderAmong, EachSocketOfThePortMustBeOfTheUserOrOfRoot) {
  constexpr uid_t own = 1000;
  EXPECT_EQ(sender_among({}, own), Sender::gone);
  EXPECT_EQ(sender_among({{own}}, own), Sender::trusted);
  EXPECT_EQ(sender_among({{0}, {own}}, own), Sender::trusted);
  EXPECT_EQ(sender_among({{1001}}, own), Sender::other);
  EXPECT_EQ(sender_among({{own}, {1001}}, own), Sender::other);
  EXPECT_EQ(sender_among({{own}}, 0), Sender::other) << "root listens to root";
}

/// Whose sockets are, as the kernel tells.
class UdpSocketsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!UdpSockets().answers()) GTEST_SKIP() << "this kernel does not tell (udp_diag)";
  }
};
class SoleSocket : public UdpSocketsTest {};
class SenderUsersTest : public UdpSocketsTest {};

TEST_F(UdpSocketsTest, TellTheUserOfASocket) {
  UdpSockets sut;
  const FileDescriptor own = socket_at(loopback);
  const auto found = sut.at(place(loopback, port_of(own)));
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 1U);
  EXPECT_EQ(found->front().user, ::geteuid());
  EXPECT_FALSE(found->front().is_sole);
}

TEST_F(UdpSocketsTest, TellAllSocketsOfAPort) {
  UdpSockets sut;
  const FileDescriptor one = socket_at(loopback);
  const FileDescriptor other = socket_at(other_loopback, port_of(one));
  const auto found = sut.with_port(port_of(one));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 2U);
}

TEST_F(UdpSocketsTest, TellTheMappedSocketOfIpv6ThatMaySendToIpv4) {
  UdpSockets sut;
  const FileDescriptor one = socket_at(loopback);
  const FileDescriptor other(::socket(AF_INET6, SOCK_DGRAM, 0));
  sockaddr_in6 mapped{};
  mapped.sin6_family = AF_INET6;
  mapped.sin6_port = htons(port_of(one));
  inet_pton(AF_INET6, "::ffff:127.0.0.2", &mapped.sin6_addr);
  if (!other || ::bind(other.get(), reinterpret_cast<sockaddr*>(&mapped), sizeof mapped) != 0) {
    GTEST_SKIP() << "no IPv6 here";
  }
  const auto found = sut.with_port(port_of(one));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 2U);
}

TEST_F(SoleSocket, LeavesItsPortToNobodyAtAnyAddress) {
  UdpSockets table;
  const FileDescriptor sut = sole_udp_socket();
  const auto found = table.at(place(loopback, port_of(sut)));
  ASSERT_TRUE(found && found->size() == 1);
  EXPECT_TRUE(found->front().is_sole);
  for (const std::uint32_t address : {loopback, other_loopback, std::uint32_t{INADDR_ANY}}) {
    const FileDescriptor thief = plain_socket();
    const int on = 1;
    ::setsockopt(thief.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    ::setsockopt(thief.get(), SOL_SOCKET, SO_REUSEPORT, &on, sizeof on);
    EXPECT_EQ(bind_to(thief, place(address, port_of(sut))), EADDRINUSE);
  }
}

TEST_F(SoleSocket, AnOrdinaryOneAtAllAddressesIsNone) {
  UdpSockets table;
  const FileDescriptor ordinary = socket_at(INADDR_ANY);
  const auto found = table.at(place(loopback, port_of(ordinary)));
  ASSERT_TRUE(found && found->size() == 1);
  EXPECT_FALSE(found->front().is_sole);
}

TEST_F(SoleSocket, HearsNothing) {
  const FileDescriptor sut = sole_udp_socket();
  const sockaddr_in to = place(loopback, port_of(sut));
  EXPECT_EQ(
      ::sendto(plain_socket().get(), "x", 1, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to),
      1);
  char letter = 0;
  EXPECT_EQ(::recv(sut.get(), &letter, 1, MSG_DONTWAIT), -1);
}

TEST_F(SenderUsersTest, OwnSocketsAreTrusted) {
  SenderUsers sut;
  ASSERT_TRUE(sut.can_tell());
  const FileDescriptor sole = sole_udp_socket();
  const FileDescriptor ordinary = socket_at(loopback);
  EXPECT_EQ(sut.sender(source_of(sole)), Sender::trusted);
  EXPECT_EQ(sut.sender(source_of(ordinary)), Sender::trusted);
}

TEST_F(SenderUsersTest, OneThatIsClosedIsGone) {
  SenderUsers sut;
  FileDescriptor socket = sole_udp_socket();
  const Source source = source_of(socket);
  EXPECT_EQ(sut.sender(source), Sender::trusted);
  socket.reset();
  EXPECT_EQ(sut.sender(source), Sender::gone);
}

class StrangerTest : public UdpSocketsTest {
 protected:
  void SetUp() override {
    UdpSocketsTest::SetUp();
    if (!can_become_stranger()) GTEST_SKIP() << "only root can become another user";
  }
  SenderUsers sut_;
};

TEST_F(StrangerTest, OfAnotherUserIsNoneTrusted) {
  ProcessOf other(stranger, [] { return int{port_of(*new FileDescriptor(sole_udp_socket()))}; });
  const int port = other.result();
  ASSERT_GT(port, 0);
  EXPECT_EQ(sut_.sender({loopback, static_cast<std::uint16_t>(port)}), Sender::other);
}

// Linux lets who has a port at one address send as if he had it at another.
TEST_F(StrangerTest, OneThatHidesBehindOurSocketAtAnotherAddressIsNotTrusted) {
  const FileDescriptor receiver = socket_at(loopback);
  const FileDescriptor ours = socket_at(loopback);
  const sockaddr_in to = place(loopback, port_of(receiver));
  EXPECT_EQ(sut_.sender(source_of(ours)), Sender::trusted);
  ProcessOf other(stranger, [&] {
    static const FileDescriptor thief = socket_at(other_loopback, port_of(ours));
    return send_as(thief, place(loopback, 0), to) ? 1 : 0;
  });
  ASSERT_EQ(other.result(), 1);
  const Source seen = source_of_next(receiver);
  ASSERT_EQ(seen, source_of(ours)) << "the address alone tells nothing";
  EXPECT_EQ(sut_.sender(seen), Sender::other);
}

TEST_F(StrangerTest, OneThatTakesThePortOfAnEndedProcessIsNotTrusted) {
  FileDescriptor ours = sole_udp_socket();
  const Source source = source_of(ours);
  EXPECT_EQ(sut_.sender(source), Sender::trusted);
  ours.reset();
  ProcessOf other(stranger, [&] {
    static const FileDescriptor heir = socket_at(loopback, source.port);
    return 1;
  });
  ASSERT_EQ(other.result(), 1);
  EXPECT_EQ(sut_.sender(source), Sender::other);
}

}  // namespace
}  // namespace tocsin
