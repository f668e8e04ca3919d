// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::link {
namespace {

using ::testing::HasSubstr;

std::optional<Options> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "link_emulator");
  return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

std::string error_of(const std::vector<const char*>& arguments) {
  try {
    (void)parse(arguments);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string end_error(const char* end) {
  return error_of({"--channel", "c", "--end", end, "--end", "gcs:/b:10.0.0.2/24"});
}

TEST(Options, ReadTheWholeCommandLine) {
  const auto sut = parse({"--channel", "c.yaml", "--walls", "w.yaml", "--seed", "7", "--end",
                          "uxv:/proc/self/fd/7:10.77.0.1/24", "--end", "gcs:/a:b:10.77.0.2/16",
                          "--control", "s", "--stats", "t", "--wireless", "u"});
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->channel_file, "c.yaml");
  EXPECT_EQ(sut->walls_file, "w.yaml");
  EXPECT_EQ(sut->seed, 7u);
  ASSERT_EQ(sut->vehicles.size(), 1u);
  EXPECT_EQ(sut->vehicles[0].name, "uxv");
  EXPECT_EQ(sut->vehicles[0].netns, "/proc/self/fd/7");
  EXPECT_EQ(sut->vehicles[0].address, "10.77.0.1");
  EXPECT_EQ(sut->vehicles[0].prefix, 24);
  EXPECT_EQ(sut->stations.front().netns, "/a:b");
  EXPECT_EQ(sut->stations.front().prefix, 16);
  EXPECT_EQ(sut->interface, "wlan0");
  EXPECT_EQ(sut->control_path, "s");
  EXPECT_EQ(sut->stats_path, "t");
  EXPECT_EQ(sut->wireless_path, "u");
}

TEST(Options, NeedBothEndsAndAChannel) {
  EXPECT_THAT(error_of({}), HasSubstr("--channel"));
  EXPECT_THAT(error_of({"--channel", "c", "--end", "uxv:/a:10.0.0.1/24"}), HasSubstr("one for"));
  EXPECT_THAT(error_of({"--channel", "c", "--end", "uxv:/a:10.0.0.1/24", "--magic"}),
              HasSubstr("--magic"));
}

TEST(Options, RejectEndsThatAreNoEnds) {
  EXPECT_EQ(end_error("uxv:/a:10.0.0.1/24"), "no error");
  EXPECT_THAT(end_error("uxv"), HasSubstr("three parts"));
  EXPECT_THAT(end_error("uxv:10.0.0.1/24"), HasSubstr("three parts"));
  EXPECT_THAT(end_error("uxv::10.0.0.1/24"), HasSubstr("names no namespace"));
  EXPECT_THAT(end_error("Uxv:/a:10.0.0.1/24"), HasSubstr("'Uxv' is not a lower-case letter"));
  EXPECT_THAT(end_error("gcs:/a:10.0.0.1/24"), HasSubstr("given twice"));
  EXPECT_THAT(end_error("uxv:/a:10.0.0.1"), HasSubstr("no prefix"));
  EXPECT_THAT(end_error("uxv:/a:10.0.0/24"), HasSubstr("'10.0.0' is not an IPv4 address"));
}

TEST(Options, TakeStationsBesideTheFirst) {
  const std::vector<const char*> ends{"--channel", "c",
                                      "--end",     "uxv:/a:10.0.0.1/24",
                                      "--site",    "south:/c:10.0.0.3/24",
                                      "--end",     "gcs:/b:10.0.0.2/24"};
  const auto sut = parse(ends);
  ASSERT_TRUE(sut);
  ASSERT_EQ(sut->stations.size(), 2U);
  EXPECT_EQ(sut->stations[0].name, "gcs");
  EXPECT_EQ(sut->stations[1].name, "south");
  EXPECT_THAT(
      error_of({"--channel", "c", "--end", "uxv:/a:10.0.0.1/24", "--site", "south:/c:10.0.0.3/24"}),
      HasSubstr("needs one for gcs"));
}

TEST(Options, TakeAnyNumberOfVehicles) {
  const auto with = [](std::vector<const char*> more) {
    more.insert(more.begin(), {"--channel", "c", "--end", "gcs:/b:10.0.0.2/24", "--end",
                               "uxv1:/a:10.0.0.11/24", "--end", "uxv2:/c:10.0.0.12/24"});
    return more;
  };
  const auto sut = parse(with({"--wireless", "/run/{vehicle}/wireless"}));
  ASSERT_EQ(sut->vehicles.size(), 2u);
  EXPECT_EQ(path_for(sut->wireless_path, sut->vehicles[1]), "/run/uxv2/wireless");
  EXPECT_THAT(error_of(with({"--control", "/run/radio.sock"})),
              HasSubstr("--control /run/radio.sock: needs {vehicle} in it, for 2 vehicles"));
  EXPECT_THAT(error_of(with({"--end", "uxv1:/d:10.0.0.13/24"})), HasSubstr("uxv1 is given twice"));
}

TEST(Options, AcceptPrefixesFrom1To30) {
  EXPECT_EQ(end_error("uxv:/a:10.0.0.1/1"), "no error");
  EXPECT_EQ(end_error("uxv:/a:10.0.0.1/30"), "no error");
  for (const char* prefix : {"0", "31", "", "-1", "2x", "24000000000"}) {
    EXPECT_THAT(end_error(("uxv:/a:10.0.0.1/" + std::string(prefix)).c_str()),
                HasSubstr("outside [1, 30]"));
  }
}

TEST(Options, RejectInterfaceNamesThatTheKernelWould) {
  const auto with = [](const char* name) {
    return error_of({"--channel", "c", "--end", "uxv:/a:10.0.0.1/24", "--end", "gcs:/b:10.0.0.2/24",
                     "--interface", name});
  };
  EXPECT_EQ(with("wlan12345678901"), "no error");
  EXPECT_THAT(with("wlan123456789012"), HasSubstr("not 1 to 15 characters"));
}

}  // namespace
}  // namespace tocsin::link
