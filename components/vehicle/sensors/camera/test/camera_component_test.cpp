// SPDX-License-Identifier: Apache-2.0
#include "camera/camera_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

topic::Location::Message location(double x_m, double yaw_rad) {
  topic::Location::Message message;
  message.pose().pose().position().x(x_m);
  message.pose().pose().orientation().z(std::sin(yaw_rad / 2));
  message.pose().pose().orientation().w(std::cos(yaw_rad / 2));
  return message;
}

class CameraTest : public ::testing::Test {
 protected:
  CameraTest() : walls_file_("camera_test_" + std::to_string(getpid()) + ".yaml") {
    std::ofstream(walls_file_) << "walls: [[4, -3, 4, 3, 7], [-4, -3, -4, 3, 7]]";
    params_.walls_file = walls_file_;
    params_.camera.width = 80;
    params_.camera.height = 60;
    params_.camera.sensor_noise = 0;
    sut_ = std::make_unique<CameraComponent>(context_, params_);
    bus_.add(*sut_);
  }
  ~CameraTest() override { std::remove(walls_file_.c_str()); }

  std::vector<topic::CameraImage::Message> run(double s) {
    bus_.run_for(seconds(s));
    return images_.take();
  }

  std::string walls_file_;
  CameraComponent::Params params_;
  SimBus bus_;
  Context context_{bus_, "camera", Role::uxv};
  SimReader<topic::CameraImage> images_{bus_};
  std::unique_ptr<CameraComponent> sut_;
};

TEST_F(CameraTest, ShowsNothingBeforeItKnowsWhereItIs) { EXPECT_TRUE(run(5).empty()); }

TEST_F(CameraTest, SendsPicturesAtItsRateHoweverOftenLocationsCome) {
  bus_.publish<topic::Location>(location(0, 0));
  EXPECT_EQ(run(1.0).size(), 9U);  // at once, and each 0.125 s to the end of the second
  std::size_t pictures = 0;
  for (int i = 0; i < 100; ++i) {
    bus_.publish<topic::Location>(location(0, 0));
    pictures += run(0.01).size();
  }
  EXPECT_EQ(pictures, 8U);
}

TEST_F(CameraTest, SendsJpegWithFrameAndStamp) {
  bus_.publish<topic::Location>(location(0, 0));
  const auto image = run(0).at(0);
  EXPECT_EQ(image.format(), "jpeg");
  EXPECT_EQ(image.header().frame_id(), "camera");
  EXPECT_EQ(image.header().stamp().sec(), 1'767'225'600);
  ASSERT_GT(image.data().size(), 500U);
  EXPECT_EQ(image.data()[0], 0xff);
  EXPECT_EQ(image.data()[1], 0xd8);
}

TEST_F(CameraTest, StopsWhenTheLocationIsOld) {
  bus_.publish<topic::Location>(location(0, 0));
  EXPECT_EQ(run(2.0).size(), 17U);
  EXPECT_TRUE(run(5.0).empty());
  bus_.publish<topic::Location>(location(0, 0));
  EXPECT_EQ(run(0).size(), 1U);
}

TEST_F(CameraTest, IgnoresALocationThatIsNotFinite) {
  bus_.publish<topic::Location>(location(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_TRUE(run(1).empty());
  bus_.publish<topic::Location>(location(std::numeric_limits<double>::infinity(), 0));
  EXPECT_TRUE(run(1).empty());
}

TEST_F(CameraTest, ShowsTheNewestOfSeveralLocations) {
  bus_.publish<topic::Location>(location(0, 0));
  const auto first = run(0).at(0).data();
  bus_.publish<topic::Location>(location(2, 0));
  bus_.publish<topic::Location>(location(0, 0));
  EXPECT_EQ(run(0.13).at(0).data(), first);  // without noise the same place is the same picture
  bus_.publish<topic::Location>(location(1, 0.3));
  EXPECT_NE(run(0.13).at(0).data(), first);
}

TEST(CameraParams, KeepTheLensBelowTheTables) {
  const auto load = [](const std::string& yaml) {
    return load_parameters<CameraComponent::Params>(YAML::Load(yaml), "camera", "file");
  };
  EXPECT_EQ(load("camera_height_m: 0.7").camera.camera_height_m, 0.7);
  EXPECT_THROW((void)load("camera_height_m: 0.71"), ConfigError);
}

TEST_F(CameraTest, SendsZerosOfTheRightNumberWhereNobodyLooksAtPictures) {
  const Computer computer;
  Context context = Context(bus_, "camera", Role::uxv).with_computer(computer);
  CameraComponent sized(context, params_);
  SimBus& bus = bus_;
  bus.add(sized);
  bus.publish<topic::Location>(location(0, 0));
  const auto images = run(0.2);  // two of each camera
  ASSERT_EQ(images.size(), 4U);
  for (const std::size_t i : {0U, 2U}) {
    const auto& zeros = images[i + 1].data();
    EXPECT_EQ(std::count(zeros.begin(), zeros.end(), 0), static_cast<std::ptrdiff_t>(zeros.size()));
    EXPECT_NEAR(static_cast<double>(zeros.size()), static_cast<double>(images[i].data().size()), 1);
  }
}

TEST(CameraReadme, ShowsTheParameters) {
  std::ifstream file(TOCSIN_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, ::testing::HasSubstr(default_yaml<CameraComponent::Params>()));
}

TEST(Camera, NeedsAWallsFile) {
  SimBus bus;
  Context context{bus, "camera", Role::uxv};
  EXPECT_THROW(CameraComponent(context, {}), ConfigError);
}

}  // namespace
}  // namespace tocsin
