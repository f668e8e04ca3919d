// SPDX-License-Identifier: Apache-2.0
#include "listening_socket.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

namespace tocsin::foxglove {
namespace {

TEST(ListeningSocketTest, ListensOnIpv6) {
  const Listening sut = open_listening_socket("::1", 0);
  if (!sut.socket) GTEST_SKIP() << "no IPv6 here: " << sut.fault;
  EXPECT_GT(sut.port, 0);
  EXPECT_TRUE(open_listening_socket("127.0.0.1", sut.port).socket);
}

TEST(ListeningSocketTest, SaysWhyItCannot) {
  const Listening first = open_listening_socket("127.0.0.1", 0);
  EXPECT_EQ(open_listening_socket("127.0.0.1", first.port).fault, "Address already in use");
  EXPECT_EQ(open_listening_socket("station", 0).fault, "'station' is not an IP address");
  EXPECT_EQ(open_listening_socket("192.0.2.1", 0).fault, "Cannot assign requested address");
}

TEST(ListeningSocketTest, TakesTheOneThatItsProcessWasStartedWithAndNoOther) {
  const Listening given = open_listening_socket("127.0.0.1", 0);
  ::fcntl(given.socket.get(), F_SETFD, 0);
  {
    const Listening sut = open_listening_socket("127.0.0.1", given.port);
    EXPECT_TRUE(sut.inherited);
    EXPECT_NE(sut.socket.get(), given.socket.get());
    EXPECT_NE(::fcntl(sut.socket.get(), F_GETFD) & FD_CLOEXEC, 0) << "children do not get it";
  }
  EXPECT_TRUE(open_listening_socket("127.0.0.1", given.port).inherited) << "it stays for the next";
  EXPECT_FALSE(open_listening_socket("127.0.0.2", given.port).inherited);
}

}  // namespace
}  // namespace tocsin::foxglove
