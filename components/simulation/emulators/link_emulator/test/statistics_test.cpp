// SPDX-License-Identifier: Apache-2.0
#include "statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "foundation/error.hpp"
#include "tun.hpp"

namespace tocsin::link {
namespace {

radio::LinkReport some_report() {
  radio::LinkReport report{};
  report.associated = true;
  report.rssi_dbm = -88.3;
  report.rssi_mean_dbm = -86.127;
  report.noise_dbm = -94;
  report.quality = 22;
  report.busy_share = 0.4567;
  report.mean_snr_db = 7.5;
  report.uplink.pushed = 10;
  report.uplink.delivered = 8;
  report.uplink.categories[0] = {7, 5, 1, 1};
  report.uplink.air.failed = 2;
  report.uplink.air.retries = 30;
  return report;
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(StatsLine, IsJsonWithBothDirections) {
  EmulatorCounters counters;
  counters.bad_commands = 3;
  counters.late = Duration{12'345'678};
  const auto sut = nlohmann::json::parse(stats_line(12.3456, some_report(), counters));
  EXPECT_EQ(sut["elapsed_s"], 12.346);
  EXPECT_EQ(sut["rssi_dbm"], -88.3);
  EXPECT_EQ(sut["rssi_mean_dbm"], -86.13);
  EXPECT_EQ(sut["quality"], 22);
  EXPECT_EQ(sut["busy_share"], 0.457);
  EXPECT_EQ(sut["uplink"]["pushed"], 10);
  EXPECT_EQ(sut["uplink"]["retries"], 30);
  EXPECT_EQ(sut["downlink"]["pushed"], 0);
  EXPECT_EQ(sut["bad_commands"], 3);
  EXPECT_EQ(sut["late_ms"], 12.35);
}

TEST(StatsLine, CountsPacketsByCategory) {
  const auto sut = nlohmann::json::parse(stats_line(0, some_report(), {}));
  const auto& voice = sut["uplink"]["categories"]["voice"];
  EXPECT_EQ(voice["pushed"], 7);
  EXPECT_EQ(voice["delivered"], 5);
  EXPECT_EQ(voice["queue_drops"], 1);
  EXPECT_EQ(voice["losses"], 1);
  EXPECT_EQ(sut["uplink"]["categories"]["background"]["pushed"], 0);
  EXPECT_EQ(sut["downlink"]["categories"].size(), 4U);
}

TEST(StatsLine, SaysNullForASignalNeverHeard) {
  radio::LinkReport report = some_report();
  report.rssi_dbm = report.rssi_mean_dbm = std::nan("");
  const auto sut = nlohmann::json::parse(stats_line(0, report, {}));
  EXPECT_TRUE(sut["rssi_dbm"].is_null());
  EXPECT_TRUE(sut["rssi_mean_dbm"].is_null());
}

TEST(WirelessText, LooksLikeTheKernels) {
  EXPECT_EQ(wireless_text("wlan1", some_report()),
            "Inter-| sta-|   Quality        |   Discarded packets               | Missed | WE\n"
            " face | tus | link level noise |  nwid  crypt   frag  retry   misc | beacon | 22\n"
            " wlan1: 0000   22.  -88.  -256        0      0      0      2      0        0\n");
}

TEST(WirelessText, ShowsZerosWithoutDotsWhenUnassociated) {
  radio::LinkReport report = some_report();
  report.associated = false;
  report.quality = 0;
  const std::string sut = wireless_text("wlan1", report);
  EXPECT_EQ(sut.substr(sut.rfind("wlan1")),
            "wlan1: 0000    0     0     0        0      0      0      0      0        0\n");
}

TEST(StatsFile, AppendsLinesAndKeepsWhatWasThere) {
  const std::string path = ::testing::TempDir() + "statistics_test_append";
  std::ofstream(path) << "old\n";
  StatsFile(path).append("new");
  EXPECT_EQ(content(path), "old\nnew\n");
  EXPECT_THROW(StatsFile("/does/not/exist"), ConfigError);
}

std::vector<std::uint8_t> ipv4_to(int a, int b, int c, int d) {
  std::vector<std::uint8_t> packet(28);
  packet[0] = 0x45;
  const int to[] = {a, b, c, d};
  for (std::size_t i = 0; i < 4; ++i) packet[16 + i] = static_cast<std::uint8_t>(to[i]);
  return packet;
}

TEST(GroupAddress, IsMulticastOrBroadcast) {
  EXPECT_TRUE(is_group_addressed(ipv4_to(239, 255, 0, 1), 24));
  EXPECT_TRUE(is_group_addressed(ipv4_to(224, 0, 0, 1), 24));
  EXPECT_FALSE(is_group_addressed(ipv4_to(223, 255, 0, 1), 24));
  EXPECT_FALSE(is_group_addressed(ipv4_to(240, 0, 0, 1), 24));
  EXPECT_TRUE(is_group_addressed(ipv4_to(255, 255, 255, 255), 24));
  EXPECT_TRUE(is_group_addressed(ipv4_to(10, 77, 0, 255), 24));
  EXPECT_FALSE(is_group_addressed(ipv4_to(10, 77, 0, 255), 16));
  EXPECT_FALSE(is_group_addressed(ipv4_to(10, 77, 0, 2), 24));
}

TEST(Dscp, IsTheUpperSixBitsOfTheTosByte) {
  std::vector<std::uint8_t> packet = ipv4_to(10, 77, 0, 2);
  packet[1] = 0xc0;
  EXPECT_EQ(dscp_of(packet), 48);
  packet[1] = 0x23;  // CS1 and both bits of ECN
  EXPECT_EQ(dscp_of(packet), 8);
}

TEST(Dscp, IsReadFromIpv6AndNotFromGarbage) {
  std::vector<std::uint8_t> packet(40);
  packet[0] = 0x6c;  // traffic class 0xc0
  EXPECT_EQ(dscp_of(packet), 48);
  packet[0] = 0x62;
  packet[1] = 0x0f;
  EXPECT_EQ(dscp_of(packet), 8);
  EXPECT_EQ(dscp_of({}), 0);
  EXPECT_EQ(dscp_of({0x45, 0xc0}), 0);
  EXPECT_EQ(dscp_of(std::vector<std::uint8_t>(28, 0xff)), 0);
}

TEST(GroupAddress, IsReadFromIpv6AndNotFromGarbage) {
  std::vector<std::uint8_t> packet(40);
  packet[0] = 0x60;
  EXPECT_FALSE(is_group_addressed(packet, 24));
  packet[24] = 0xff;
  EXPECT_TRUE(is_group_addressed(packet, 24));
  packet.pop_back();
  EXPECT_FALSE(is_group_addressed(packet, 24));
  EXPECT_FALSE(is_group_addressed({}, 24));
  EXPECT_FALSE(is_group_addressed({0x45, 0xff}, 24));
}

}  // namespace
}  // namespace tocsin::link
