// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cstdint>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// A UDP socket on loopback, at a port of the kernel's choice; sends to itself.
class SelfSender {
 public:
  SelfSender() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    own_.sin_family = AF_INET;
    own_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof own_;
    EXPECT_EQ(::bind(socket_.get(), address(), size), 0);
    EXPECT_EQ(::getsockname(socket_.get(), address(), &size), 0);
  }
  [[nodiscard]] const FileDescriptor& socket() const { return socket_; }
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

}  // namespace tocsin
