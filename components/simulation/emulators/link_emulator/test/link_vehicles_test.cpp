// SPDX-License-Identifier: Apache-2.0
// The program between a station and two vehicles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "harness.hpp"

namespace tocsin::link {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

bool passes(UdpSocket& from, UdpSocket& to) {
  from.send(1, 100);
  return to.receive(1000).has_value();
}

/// A station and two vehicles, each with a socket for each of the others.
class LinkVehicles : public LinkEmulator {
 protected:
  [[nodiscard]] static std::string text_of(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  static inline const char* const first = "10.77.0.1";
  static inline const char* const station = "10.77.0.2";
  static inline const char* const second = "10.77.0.3";
};

TEST_F(LinkVehicles, EachHearsWhatIsForIt) {
  Emulator sut(open_channel, Third::vehicle);
  ASSERT_TRUE(sut.ready());
  UdpSocket first_to_station(Namespaces::uxv(), first, station);
  UdpSocket second_to_station(Namespaces::second_uxv(), second, station);
  {
    UdpSocket to_first(Namespaces::gcs(), station, first);
    EXPECT_TRUE(passes(to_first, first_to_station));
    EXPECT_TRUE(passes(first_to_station, to_first));
  }
  UdpSocket to_second(Namespaces::gcs(), station, second);
  EXPECT_TRUE(passes(to_second, second_to_station));
  EXPECT_TRUE(passes(second_to_station, to_second));
  EXPECT_FALSE(first_to_station.receive(0));
}

TEST_F(LinkVehicles, TheAccessPointSendsOnWhatIsForTheOther) {
  Emulator sut(open_channel, Third::vehicle);
  ASSERT_TRUE(sut.ready());
  UdpSocket one(Namespaces::uxv(), first, second);
  UdpSocket other(Namespaces::second_uxv(), second, first);
  EXPECT_TRUE(passes(one, other));
  EXPECT_TRUE(passes(other, one));
}

TEST_F(LinkVehicles, EachHasASignalOfItsOwn) {
  Emulator sut(open_channel, Third::vehicle);
  ASSERT_TRUE(sut.ready());
  sut.command("pos 900000 0", "uxv2_control");
  UdpSocket one(Namespaces::uxv(), first, station);
  UdpSocket other(Namespaces::second_uxv(), second, station);
  const auto is_silent = [&] {
    other.send(1, 100);
    return text_of(sut.file("uxv2_wireless")).find("wlan0: 0000    0   ") != std::string::npos;
  };
  for (int i = 0; i < 100 && !is_silent(); ++i) (void)other.receive(100);
  EXPECT_TRUE(is_silent());
  EXPECT_THAT(text_of(sut.file("uxv_wireless")), HasSubstr(".  -256"));
  EXPECT_THAT(text_of(sut.file("uxv_stats")), HasSubstr("\"x_m\":0.0"));
  EXPECT_THAT(text_of(sut.file("uxv2_stats")), HasSubstr("\"x_m\":900000.0"));
  UdpSocket to_first(Namespaces::gcs(), station, first);
  EXPECT_TRUE(passes(one, to_first));
}

/// The third end is a station.
TEST_F(LinkVehicles, StationsAreOnOneWireAndEachHearsWhatIsForIt) {
  Emulator sut(open_channel, Third::station);
  ASSERT_TRUE(sut.ready());
  {
    UdpSocket south(Namespaces::second_uxv(), second, first);
    UdpSocket vehicle(Namespaces::uxv(), first, second);
    EXPECT_TRUE(passes(vehicle, south));
    EXPECT_TRUE(passes(south, vehicle));
  }
  UdpSocket south_to_gcs(Namespaces::second_uxv(), second, station);
  {
    UdpSocket vehicle(Namespaces::uxv(), first, station);
    UdpSocket gcs(Namespaces::gcs(), station, first);
    EXPECT_TRUE(passes(vehicle, gcs));
    EXPECT_FALSE(south_to_gcs.receive(0));
    sut.command("set outage 60");
    EXPECT_FALSE(passes(vehicle, gcs));
  }
  UdpSocket gcs_to_south(Namespaces::gcs(), station, second);
  EXPECT_TRUE(passes(south_to_gcs, gcs_to_south)) << "by wire";
  EXPECT_TRUE(passes(gcs_to_south, south_to_gcs));
}

}  // namespace
}  // namespace tocsin::link
