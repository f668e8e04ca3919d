// SPDX-License-Identifier: Apache-2.0
#include "transport/socket_wait.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>

#include "foundation/time.hpp"
#include "transport/self_sender.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

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
