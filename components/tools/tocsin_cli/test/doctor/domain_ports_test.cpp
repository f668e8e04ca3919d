// SPDX-License-Identifier: Apache-2.0
#include "domain_ports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace tocsin::doctor {
namespace {

using ::testing::ElementsAre;

TEST(DomainPorts, ReadsLocalPortsOfProcNetUdp) {
  const std::string text =
      "   sl  local_address rem_address   st tx_queue rx_queue\n"
      "  176: 0100007F:1CF2 00000000:0000 07 00000000:00000000\n"
      "  177: 00000000:1CF3 00000000:0000 07 00000000:00000000\n";
  EXPECT_THAT(udp_ports(text), ElementsAre(7410, 7411));
}

TEST(DomainPorts, CountsParticipantsByTheirDiscoveryPort) {
  EXPECT_EQ(participants({7410, 7411, 7412}, 0), 2);  // ids 0 and 1; 7411 is user traffic
  EXPECT_EQ(participants({7410, 7411, 7412}, 1), 0);
  EXPECT_EQ(participants({7400 + 250 * 40 + 10}, 40), 1);
}

/// A socket bound to a UDP port of loopback.
class BoundSocket {
 public:
  explicit BoundSocket(int port) : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    own.sin_port = htons(static_cast<std::uint16_t>(port));
    bound_ = ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
  }
  ~BoundSocket() { ::close(descriptor_); }
  BoundSocket(const BoundSocket&) = delete;
  BoundSocket& operator=(const BoundSocket&) = delete;
  [[nodiscard]] bool bound() const { return bound_; }

 private:
  int descriptor_;
  bool bound_;
};

TEST(DomainPorts, AParticipantOfThisComputerIsCountedWhileItLives) {
  const auto count = [] {
    std::ostringstream text;
    text << std::ifstream("/proc/net/udp").rdbuf();
    return participants(udp_ports(text.str()), 93);
  };
  const int before = count();
  {
    const BoundSocket participant(7400 + 250 * 93 + 10 + 2 * 77);
    if (!participant.bound()) GTEST_SKIP() << "the port is in use";
    EXPECT_EQ(count(), before + 1);
  }
  EXPECT_EQ(count(), before);
}

}  // namespace
}  // namespace tocsin::doctor
