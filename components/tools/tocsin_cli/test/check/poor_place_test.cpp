// SPDX-License-Identifier: Apache-2.0
#include "poor_place.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "geometry/wall.hpp"
#include "radio_channel/channel_files.hpp"

namespace tocsin::check {
namespace {

const std::string config = TOCSIN_REPOSITORY "/config/";

/// A room of 20 m by 20 m around the access point.
std::vector<geometry::Wall> room() {
  return {
      {-10, -10, 10, -10, 0}, {10, -10, 10, 10, 0}, {10, 10, -10, 10, 0}, {-10, 10, -10, -10, 0}};
}

TEST(PoorPlace, OfAWeakRadioIsOneWhereSomethingStillComesThrough) {
  radio::ChannelParams params;
  params.tx_dbm = -40;
  const PoorPlace sut = poor_place(params, room());
  EXPECT_EQ(sut.mean_snr_db, 8);
  EXPECT_GT(sut.bytes_per_s, 500'000);
  EXPECT_LT(sut.bytes_per_s, poor_place({}, room()).bytes_per_s / 2);
}

TEST(PoorPlace, CarriesLessWhereOthersSpeak) {
  radio::ChannelParams params;
  const double alone = poor_place(params, room()).bytes_per_s;
  params.background_load = 0.5;
  EXPECT_LT(poor_place(params, room()).bytes_per_s, 0.7 * alone);
}

TEST(PoorPlace, NeedsARadioThatIsAModelOfAPlace) {
  deployment::Deployment deployment;
  EXPECT_FALSE(poor_place_of(deployment));
  deployment.radio = {config + "radio/classroom.yaml", config + "maps/classroom.walls.yaml"};
  const auto demo = poor_place_of(deployment);
  ASSERT_TRUE(demo);
  EXPECT_EQ(demo->channel, config + "radio/classroom.yaml");
  deployment.radio = {config + "radio/replay.yaml", ""};
  EXPECT_FALSE(poor_place_of(deployment));
  const TemporaryFolder folder;
  deployment.radio = {folder.write("c.yaml", "radio_channel: {mode: bernoulli}\n"), ""};
  EXPECT_FALSE(poor_place_of(deployment));
  deployment.radio = {folder.path("none.yaml"), ""};
  EXPECT_THROW((void)poor_place_of(deployment), ConfigError);
}

}  // namespace
}  // namespace tocsin::check
