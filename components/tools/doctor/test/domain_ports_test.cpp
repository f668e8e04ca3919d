// SPDX-License-Identifier: Apache-2.0
#include "domain_ports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(DomainPorts, NonsenseHasNoPorts) { EXPECT_TRUE(udp_ports("one\ntwo\n\n").empty()); }

TEST(DomainPorts, CountsParticipantsByTheirDiscoveryPort) {
  EXPECT_EQ(participants({7410, 7411, 7412}, 0), 2);  // ids 0 and 1; 7411 is user traffic
  EXPECT_EQ(participants({7410, 7411, 7412}, 1), 0);
  EXPECT_EQ(participants({7400 + 250 * 40 + 10}, 40), 1);
}

TEST(DomainPorts, TheNextDomainsPortsDoNotCount) {
  EXPECT_EQ(participants({7648}, 0), 1);  // id 119
  EXPECT_EQ(participants({7650, 7660}, 0), 0);
  EXPECT_EQ(participants({7650, 7660}, 1), 1);
}

}  // namespace
}  // namespace tocsin::doctor
