// SPDX-License-Identifier: Apache-2.0
#include "devices/wireless.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <utime.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <utility>

#include "wireless_reader.hpp"

namespace tocsin::network {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

const std::string head =
    "Inter-| sta-|   Quality        |   Discarded packets               | Missed | WE\n"
    " face | tus | link level noise |  nwid  crypt   frag  retry   misc | beacon | 22\n";

// Lines of a real kernel (Linux 6.1, mac80211_hwsim): associated, and lost or not yet associated.
const std::string good =
    " wlan1: 0000   22.  -88.  -256        0      0      0      0      1        0\n";
const std::string silent =
    " wlan1: 0000    0     0     0        0      0      0      0      0        0\n";

WirelessReading parse(const std::string& lines, const std::string& interface = "wlan1") {
  return parse_proc_wireless(head + lines, interface);
}

TEST(ProcWireless, ReadsSignalAndQualityOfARealKernel) {
  const WirelessReading sut = parse(good);
  EXPECT_EQ(sut.source, WirelessSource::proc);
  EXPECT_TRUE(sut.associated);
  EXPECT_THAT(sut.signal_dbm, Optional(-88.0));
  EXPECT_THAT(sut.quality, Optional(22.0));
  EXPECT_EQ(sut.note, "");
}

TEST(ProcWireless, ReadsEachColumn) {
  struct {
    const char* columns;
    std::optional<double> quality, signal_dbm, noise_dbm;
  } const rows[] = {{"22. -88. -256", 22, -88, {}},  // -256: invalid
                    {"22. -88. -255.", 22, -88, -255},
                    {"22 -88 -256", 22, -88, {}},     // not renewed since the last look
                    {"0. -110. -256", 0, -110, {}}};  // very poor, but associated
  for (const auto& [columns, quality, signal_dbm, noise_dbm] : rows) {
    const WirelessReading sut = parse(" wlan1: 0000 " + std::string(columns) + " 1 2 3 44 5 6\n");
    EXPECT_TRUE(sut.associated) << columns;
    EXPECT_EQ(sut.quality, quality) << columns;
    EXPECT_EQ(sut.signal_dbm, signal_dbm) << columns;
    EXPECT_EQ(sut.noise_dbm, noise_dbm) << columns;
    EXPECT_THAT(sut.tx_failed, Optional(44U));
    EXPECT_THAT(sut.beacon_loss, Optional(6U));
    EXPECT_EQ(sut.tx_retries, std::nullopt);
  }
}

TEST(ProcWireless, TakesZerosWithoutDotsAsUnassociated) {
  const WirelessReading sut = parse(silent);
  EXPECT_EQ(sut.source, WirelessSource::proc);
  EXPECT_FALSE(sut.associated);
  EXPECT_EQ(sut.signal_dbm, std::nullopt);
  EXPECT_EQ(sut.noise_dbm, std::nullopt);
  EXPECT_EQ(sut.quality, std::nullopt);
  EXPECT_EQ(sut.note, "not associated");
}

TEST(ProcWireless, DoesNotTakeAnUnscaledLevelForDbm) {
  const WirelessReading sut = parse(" wlan1: 0000 40. 168. 0 0 0 0 0 0 0\n");
  EXPECT_EQ(sut.signal_dbm, std::nullopt);
  EXPECT_EQ(sut.quality, std::nullopt);
  EXPECT_THAT(sut.note, HasSubstr("no signal in dBm"));
}

TEST(ProcWireless, SaysThatAWiredInterfaceIsNotWireless) {
  const WirelessReading sut = parse(good, "eth0");
  EXPECT_EQ(sut.source, WirelessSource::absent);
  EXPECT_EQ(sut.note, "eth0 is not a wireless interface");
  EXPECT_EQ(parse_proc_wireless("", "wlan1").source, WirelessSource::absent);
}

TEST(ProcWireless, TellsInterfacesWithACommonPrefixApart) {
  const std::string lines =
      " wlan10: 0000 10. -100. -256 0 0 0 0 0 0\n wlan1: 0000 60. -50. -256 0 0 0 0 0 0\n";
  EXPECT_THAT(parse(lines).signal_dbm, Optional(-50.0));
  EXPECT_THAT(parse(lines, "wlan10").signal_dbm, Optional(-100.0));
  EXPECT_EQ(parse(lines, "wlan").source, WirelessSource::absent);
}

TEST(ProcWireless, RejectsALineThatIsCutOrDamaged) {
  for (const char* columns : {" 0000 22. -88. -256 0 0 0 0 0", " 0000 22. x -256 0 0 0 0 0 0",
                              " 0000 22. nan -256 0 0 0 0 0 0", ""}) {
    EXPECT_THAT(parse(" wlan1:" + std::string(columns) + "\n").note, HasSubstr("cannot be read"));
  }
}

TEST(ProcWireless, SurvivesAnyText) {
  std::mt19937 random(11);
  const std::string letters = " wlan1:.-0123456789\nabcxe|";
  for (int i = 0; i < 20000; ++i) {
    std::string text = head + good;
    for (int k = 0; k < 8; ++k) text[random() % text.size()] = letters[random() % letters.size()];
    (void)parse_proc_wireless(text, "wlan1");
  }
}

TEST(LinkQuality, IsSignalPlus110WithinItsEnds) {
  // Pairs seen on a booted kernel with mac80211_hwsim.
  for (const auto& [signal_dbm, quality] : {std::pair(-35.0, 70),
                                            {-45, 65},
                                            {-60, 50},
                                            {-100, 10},
                                            {-110, 0},
                                            {-111, 0},
                                            {std::nan(""), 0}}) {
    EXPECT_EQ(link_quality(signal_dbm), quality) << signal_dbm;
  }
}

/// A file in the format of /proc/net/wireless, removed at the end.
class WirelessReaderTest : public ::testing::Test {
 protected:
  WirelessReaderTest() : path_("wireless_test_" + std::to_string(getpid())) {}
  ~WirelessReaderTest() override { std::remove(path_.c_str()); }
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::string path_;
};

TEST_F(WirelessReaderTest, ReadsTheFileForAnInterfaceThatNl80211DoesNotKnow) {
  WirelessReader sut("lo", path_);
  EXPECT_THAT(sut.read().note, HasSubstr(path_ + " cannot be read"));
  write(head);
  EXPECT_THAT(sut.read().note, HasSubstr("lo is not a wireless interface"));
  write(head + "    lo: 0000 30. -80. -94. 0 0 0 0 0 0\n");
  EXPECT_THAT(sut.read().signal_dbm, Optional(-80.0));
  EXPECT_EQ(sut.read().source, WirelessSource::proc);
}

TEST_F(WirelessReaderTest, DoesNotBelieveAFileThatNobodyUpdates) {
  write(head + "    lo: 0000 30. -80. -94. 0 0 0 0 0 0\n");
  utimbuf hour_old{time(nullptr) - 3600, time(nullptr) - 3600};
  ASSERT_EQ(utime(path_.c_str(), &hour_old), 0);
  const WirelessReading sut = WirelessReader("lo", path_).read();
  EXPECT_EQ(sut.source, WirelessSource::absent);
  EXPECT_THAT(sut.note, HasSubstr("no longer updated"));
}

TEST_F(WirelessReaderTest, DoesNotBelieveAFileAboutAnInterfaceThatIsNotThere) {
  write(head + " deleted0: 0000 30. -80. -94. 0 0 0 0 0 0\n");
  const WirelessReading sut = WirelessReader("deleted0", path_).read();
  EXPECT_EQ(sut.source, WirelessSource::absent);
  EXPECT_EQ(sut.note, "there is no interface deleted0");
  EXPECT_EQ(sut.signal_dbm, std::nullopt);
}

/// The recorded outputs of a real kernel, when they are at hand.
TEST(ProcWireless, ReadsTheRecordedFiles) {
  const char* root = std::getenv("TOCSIN_SHARED");
  const std::string folder =
      (root ? std::string(root) : TOCSIN_REPOSITORY "/../shared") + "/data/wireless/";
  std::ifstream file(folder + "proc_net_wireless.txt");
  if (!file) GTEST_SKIP() << "no recorded data in " << folder;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(parse_proc_wireless(text, "wlan1").signal_dbm, Optional(-88.0));
}

}  // namespace
}  // namespace tocsin::network
