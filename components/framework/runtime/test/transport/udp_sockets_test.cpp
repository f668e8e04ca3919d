// SPDX-License-Identifier: Apache-2.0
#include "transport/udp_sockets.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "foundation/time.hpp"
#include "transport/self_sender.hpp"

namespace tocsin {
namespace {

using namespace std::chrono_literals;

/// Receives on loopback, with a pause between two looks.
class ReceiveDatagramsTest : public ::testing::Test {
 protected:
  ~ReceiveDatagramsTest() override {
    stopping_ = true;
    (void)::shutdown(socket_.socket().get(), SHUT_RD);
    thread_.join();
  }
  void start(Duration pause, int wanted) {
    thread_ = std::thread([this, pause, wanted] {
      const auto on_datagram = [&](const std::uint8_t*, std::size_t, const sockaddr_in&) {
        if (++received_ == wanted) all_.set_value();
      };
      receive_datagrams(socket_.socket(), stopping_, on_datagram, [pause] { return pause; });
    });
  }
  void send() { socket_.send(); }
  [[nodiscard]] bool all_come() {
    return all_.get_future().wait_for(30s) == std::future_status::ready;
  }

 private:
  SelfSender socket_;
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
