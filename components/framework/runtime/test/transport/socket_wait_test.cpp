// SPDX-License-Identifier: Apache-2.0
#include "transport/socket_wait.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <chrono>

#include "foundation/file_descriptor.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// On loopback, at a port of the kernel's choice; sends to itself.
class SelfSender {
 public:
  SelfSender() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    own_.sin_family = AF_INET;
    own_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof own_;
    EXPECT_EQ(::bind(socket_.get(), address(), size), 0);
    EXPECT_EQ(::getsockname(socket_.get(), address(), &size), 0);
  }
  [[nodiscard]] std::uint16_t port() const { return ntohs(own_.sin_port); }
  void send() { EXPECT_EQ(::sendto(socket_.get(), "x", 1, 0, address(), sizeof own_), 1); }
  void receive() {
    char byte = 0;
    EXPECT_EQ(::recv(socket_.get(), &byte, 1, 0), 1);
  }

 private:
  [[nodiscard]] sockaddr* address() { return reinterpret_cast<sockaddr*>(&own_); }
  FileDescriptor socket_;
  sockaddr_in own_{};
};

TEST(SocketWait, TellsHowLongThePacketThatWasReadLastHasWaited) {
  SelfSender socket;
  const SocketWait sut(socket.port());
  const auto sent_and_read = [&](milliseconds wait) {
    const auto begin = steady_clock::now();
    socket.send();
    while (steady_clock::now() - begin < wait) (void)::poll(nullptr, 0, 1);
    socket.receive();
    const Duration waited = sut.of_last();
    EXPECT_LE(waited, steady_clock::now() - begin + milliseconds(1));
    return waited;
  };
  // The kernel begins to note the time a while after it was asked first.
  const auto end = steady_clock::now() + std::chrono::seconds(10);
  while (sent_and_read(milliseconds(30)) < milliseconds(29) && steady_clock::now() < end) continue;
  EXPECT_GE(sent_and_read(milliseconds(60)), milliseconds(59));
  EXPECT_LT(sent_and_read(milliseconds(0)), milliseconds(59));
}

TEST(SocketWait, IsZeroWhereThereIsNoSuchSocket) {
  std::uint16_t port = 0;
  {
    const SelfSender gone;
    port = gone.port();
  }
  EXPECT_EQ(SocketWait(port).of_last(), Duration{0});
}

TEST(HandingOn, IsOfItsThreadAndEndsWithIt) {
  EXPECT_EQ(waited_in_socket(), Duration{0});
  {
    const HandingOn turn(seconds(3));
    EXPECT_EQ(waited_in_socket(), seconds(3));
  }
  EXPECT_EQ(waited_in_socket(), Duration{0});
}

}  // namespace
}  // namespace tocsin
