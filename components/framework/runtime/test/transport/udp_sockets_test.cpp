// SPDX-License-Identifier: Apache-2.0
#include "transport/udp_sockets.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "foundation/file_descriptor.hpp"
#include "foundation/time.hpp"

namespace tocsin {
namespace {

using namespace std::chrono_literals;

/// Receives on loopback, with a pause between two looks.
class ReceiveDatagramsTest : public ::testing::Test {
 protected:
  ReceiveDatagramsTest() {
    at_.sin_family = AF_INET;
    at_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at_;
    auto* const place = reinterpret_cast<sockaddr*>(&at_);
    EXPECT_EQ(::bind(socket_.get(), place, size), 0);
    EXPECT_EQ(::getsockname(socket_.get(), place, &size), 0);
  }
  ~ReceiveDatagramsTest() override {
    stopping_ = true;
    (void)::shutdown(socket_.get(), SHUT_RD);
    thread_.join();
  }
  void start(Duration pause, int wanted) {
    thread_ = std::thread([this, pause, wanted] {
      const auto on_datagram = [&](const std::uint8_t*, std::size_t, const sockaddr_in&) {
        if (++received_ == wanted) all_.set_value();
      };
      receive_datagrams(socket_, stopping_, on_datagram, [pause] { return pause; });
    });
  }
  void send() {
    const auto* const to = reinterpret_cast<const sockaddr*>(&at_);
    EXPECT_EQ(::sendto(socket_.get(), "ab", 2, 0, to, sizeof at_), 2);
  }
  [[nodiscard]] bool all_come() {
    return all_.get_future().wait_for(30s) == std::future_status::ready;
  }

 private:
  FileDescriptor socket_{::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
  sockaddr_in at_{};
  std::atomic<bool> stopping_{false};
  int received_ = 0;
  std::promise<void> all_;
  std::thread thread_;
};

TEST_F(ReceiveDatagramsTest, HandsOnAllThatCameDuringAPause) {
  for (int i = 0; i < 20; ++i) send();
  start(1s, 21);
  send();
  EXPECT_TRUE(all_come());
}

TEST_F(ReceiveDatagramsTest, EndsInThePause) {
  send();
  start(1h, 1);
  EXPECT_TRUE(all_come());  // the test ends only if the thread does
}

}  // namespace
}  // namespace tocsin
