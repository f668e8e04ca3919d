// SPDX-License-Identifier: Apache-2.0
#include "map_server/map_server_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
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

TEST_F(MapServerComponentTest, RefusesToStartWithoutAMap) {
  params_.map_file = "";
  EXPECT_EQ(error_of_start(), "map_server.map_file: is required");
  params_.map_file = "/nowhere/m.yaml";
  EXPECT_THAT(error_of_start(), HasSubstr("/nowhere/m.yaml"));
}

}  // namespace
}  // namespace tocsin
