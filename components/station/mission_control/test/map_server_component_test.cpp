// SPDX-License-Identifier: Apache-2.0
#include "map_server/map_server_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MapServerComponentTest : public ::testing::Test {
 protected:
  MapServerComponentTest() {
    std::filesystem::create_directories(folder_);
    // A wall, unknown and free above; free, free and wall below.
    write("m.pgm", "P2 3 2 255\n0 128 255\n255 255 0\n");
    params_.map_file =
        write("m.yaml", "image: m.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nfree_thresh: 0.1\n");
  }
  ~MapServerComponentTest() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  void start() {
    sut_ = std::make_unique<MapServerComponent>(context_, params_);
    bus_.add(*sut_);
    bus_.run_for(seconds(0.1));
  }
  std::string error_of_start() {
    try {
      start();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_map_server_" + std::to_string(::getpid()));
  SimBus bus_;
  Context context_{bus_, "map_server", Role::gcs};
  MapServerComponent::Params params_;
  std::unique_ptr<MapServerComponent> sut_;
  SimReader<topic::Map> maps_{bus_};
  SimReader<topic::Tf> transforms_{bus_};
  SimWriter<topic::Location> locations_{bus_};
};

TEST_F(MapServerComponentTest, PublishesTheMapOnceRowByRowFromTheOriginUp) {
  start();
  bus_.run_for(seconds(60));
  const auto maps = maps_.take();
  ASSERT_EQ(maps.size(), 1U);
  const auto& info = maps[0].info();
  EXPECT_EQ(maps[0].header().frame_id(), "map");
  EXPECT_EQ(info.width(), 3U);
  EXPECT_EQ(info.height(), 2U);
  EXPECT_EQ(info.resolution(), 0.5F);
  EXPECT_EQ(info.origin().position().x(), -1);
  EXPECT_EQ(info.origin().position().y(), 2);
  EXPECT_EQ(info.origin().orientation().w(), 1);
  EXPECT_THAT(maps[0].data(), ElementsAre(0, 0, 100, 100, -1, 0));
}

TEST_F(MapServerComponentTest, PublishesEachPositionAsTheVehiclesFrame) {
  start();
  topic::Location::Message location;
  location.header().frame_id("map");
  location.header().stamp().sec(7);
  location.pose().pose().position().x(1.5);
  location.pose().pose().position().y(-2);
  location.pose().pose().orientation().z(1);
  ASSERT_EQ(locations_.write(location), Status::ok);
  bus_.run_for(seconds(0.1));
  const auto messages = transforms_.take();
  ASSERT_EQ(messages.size(), 1U);
  ASSERT_EQ(messages[0].transforms().size(), 1U);
  const auto& transform = messages[0].transforms()[0];
  EXPECT_EQ(transform.header().frame_id(), "map");
  EXPECT_EQ(transform.header().stamp().sec(), 7);
  EXPECT_EQ(transform.child_frame_id(), "base_footprint");
  EXPECT_EQ(transform.transform().translation().x(), 1.5);
  EXPECT_EQ(transform.transform().translation().y(), -2);
  EXPECT_EQ(transform.transform().rotation().z(), 1);
}

TEST_F(MapServerComponentTest, PublishesNoFrameWhereNoneIsSet) {
  params_.vehicle_frame = "";
  start();
  ASSERT_EQ(locations_.write(topic::Location::Message()), Status::ok);
  bus_.run_for(seconds(0.1));
  EXPECT_TRUE(transforms_.take().empty());
}

TEST_F(MapServerComponentTest, RefusesToStartWithoutTheMapThatItIsToldOf) {
  params_.map_file = "/nowhere/m.yaml";
  EXPECT_THAT(error_of_start(), HasSubstr("/nowhere/m.yaml"));
}

/// Without a file: the map that the vehicle makes.
class MapServerTilesTest : public MapServerComponentTest {
 protected:
  MapServerTilesTest() {
    params_.map_file = "";
    start();
  }
  static topic::MapTiles::Message tile(int column, navigation::Cell cell, unsigned session = 7) {
    topic::MapTiles::Message message;
    message.session(session);
    message.column(column);
    message.resolution(0.05F);
    message.side(64);
    message.cells(navigation::packed(navigation::TileMap::Tile(64 * 64, cell)));
    return message;
  }
  void send(const topic::MapTiles::Message& message) {
    bus_.publish<topic::MapTiles>(message);
    bus_.run_for(seconds(3));
  }
  /// Of the newest map that was published.
  std::size_t cells() {
    for (const auto& map : maps_.take()) cells_ = map.data().size();
    return cells_;
  }
  SimReader<topic::MapUpdates> updates_{bus_};
  std::size_t cells_ = 0;
};

TEST_F(MapServerTilesTest, MakesAMapOfTilesInWhateverOrderTheyCome) {
  EXPECT_EQ(cells(), 0U);
  send(tile(2, navigation::Cell::free));
  send(tile(0, navigation::Cell::occupied));
  EXPECT_EQ(cells(), 3U * 64 * 64);
  send(tile(0, navigation::Cell::occupied));
  EXPECT_EQ(updates_.take().size(), 0U) << "nothing has changed";
  send(tile(0, navigation::Cell::free));
  EXPECT_EQ(updates_.take().size(), 1U);
}

TEST_F(MapServerTilesTest, ALateTileOfAnotherMapIsPassedOverAndAnotherMapBegins) {
  send(tile(0, navigation::Cell::free));
  send(tile(1, navigation::Cell::free));
  EXPECT_EQ(cells(), 2U * 64 * 64);
  send(tile(5, navigation::Cell::free, 8));
  send(tile(5, navigation::Cell::free, 8));
  send(tile(1, navigation::Cell::free));
  EXPECT_EQ(cells(), 2U * 64 * 64);
  for (int i = 0; i < 3; ++i) send(tile(5, navigation::Cell::free, 8));
  EXPECT_EQ(cells(), 64U * 64);
}

TEST_F(MapServerTilesTest, RefusesTilesThatAreNone) {
  send(tile(0, navigation::Cell::free));
  auto bad = tile(1, navigation::Cell::free);
  bad.resolution(std::numeric_limits<float>::quiet_NaN());
  send(bad);
  bad = tile(1, navigation::Cell::free);
  bad.side(63);
  send(bad);
  bad = tile(1, navigation::Cell::free);
  bad.cells().pop_back();
  send(bad);
  bad = tile(1, navigation::Cell::free);
  bad.cells()[3] = 0xff;
  send(bad);
  send(tile(std::numeric_limits<int>::max(), navigation::Cell::free));
  send(tile(30000, navigation::Cell::free));
  EXPECT_EQ(cells(), 64U * 64);
}

}  // namespace
}  // namespace tocsin
