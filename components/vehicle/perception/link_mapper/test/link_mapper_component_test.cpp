// SPDX-License-Identifier: Apache-2.0
#include "link_mapper/link_mapper_component.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "foundation/read_file.hpp"
#include "geometry/pose_message.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// A vehicle that drives along x, whose signal falls by 2 dB a metre.
class LinkMapperComponentTest : public ::testing::Test {
 protected:
  LinkMapperComponentTest() {
    std::filesystem::create_directories(folder_);
    computer_.keeps_files = true;
    params_.map_name = (folder_ / "floor").string();
    params_.learn_every_s = 2;
    params_.save_every_s = 2;
  }
  ~LinkMapperComponentTest() override {
    sut_.reset();
    std::filesystem::remove_all(folder_);
  }
  void start() {
    sut_ = std::make_unique<LinkMapperComponent>(context_, params_);
    bus_.add(*sut_);
  }
  void stop() {
    bus_.remove(*sut_);
    sut_.reset();
  }
  void tell_pose(double deviation_m = 0.02) {
    topic::AmclPose::Message pose;
    pose.header().frame_id("map");
    pose.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>({x_m_, 1, 0}));
    pose.pose().covariance()[0] = pose.pose().covariance()[7] = deviation_m * deviation_m;
    bus_.publish<topic::AmclPose>(pose);
  }
  void measure(double signal_dbm, double lost_share = 0) {
    topic::NetworkQuality::Message quality;
    quality.wireless_source("nl80211");
    quality.signal_dbm(static_cast<float>(signal_dbm));
    quality.per_percent(static_cast<float>(100 * lost_share));
    bus_.publish<topic::NetworkQuality>(quality);
  }
  void drive(int steps, double deviation_m = 0.02) {
    for (int i = 0; i < steps; ++i) {
      x_m_ += 0.4;
      tell_pose(deviation_m);
      measure(-40 - 2 * x_m_, x_m_ < 20 ? 0 : 1);
      bus_.run_for(seconds(0.2));
      for (auto& grid : grids_.take()) grid_ = std::move(grid);
    }
  }
  [[nodiscard]] std::size_t lines() const {
    const std::string text = read_file(file_.string(), 1'000'000);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_link_mapper_" + std::to_string(::getpid()));
  const std::filesystem::path file_ = folder_ / "floor.signal.csv";
  SimBus bus_;
  Computer computer_;
  Context context_ = Context{bus_, "link_mapper", Role::uxv}.with_computer(computer_);
  LinkMapperComponent::Params params_;
  std::unique_ptr<LinkMapperComponent> sut_;
  SimReader<topic::LinkMap> grids_{bus_};
  SimReader<topic::LinkRisk> risks_{bus_};
  topic::LinkMap::Message grid_;
  double x_m_ = 0;
};

TEST_F(LinkMapperComponentTest, PublishesWhatItHasLearned) {
  start();
  drive(7);
  bus_.run_for(seconds(5));
  EXPECT_TRUE(grids_.take().empty()) << "7 places are too few";
  drive(40);
  EXPECT_EQ(grid_.header().frame_id(), "map");
  EXPECT_FLOAT_EQ(grid_.info().resolution(), 0.5F);
  ASSERT_EQ(grid_.data().size(), std::size_t{grid_.info().width()} * grid_.info().height());
  const auto at = [this](double x_m) {
    const auto column =
        static_cast<std::size_t>((x_m - grid_.info().origin().position().x()) / 0.5);
    const auto row = static_cast<std::size_t>((1 - grid_.info().origin().position().y()) / 0.5);
    return int{static_cast<std::int8_t>(grid_.data()[row * grid_.info().width() + column])};
  };
  EXPECT_NEAR(at(2), 100 * (14.0 / 60), 6);
  EXPECT_NEAR(at(12), 100 * (34.0 / 60), 6);
}

TEST_F(LinkMapperComponentTest, TellsWhereTheLinkIsLost) {
  start();
  drive(75);  // from where nothing is lost to -100 dBm
  const auto risks = risks_.take();
  ASSERT_FALSE(risks.empty());
  const auto& risk = risks.back();
  ASSERT_EQ(risk.data().size(), std::size_t{risk.info().width()} * risk.info().height());
  const auto at = [&risk](double x_m) {
    const auto column = static_cast<std::size_t>((x_m - risk.info().origin().position().x()) / 0.5);
    const auto row = static_cast<std::size_t>((1 - risk.info().origin().position().y()) / 0.5);
    return int{static_cast<std::int8_t>(risk.data()[row * risk.info().width() + column])};
  };
  EXPECT_LT(at(10), 2);
  EXPECT_NEAR(at(20), 50, 25) << "half is lost at -80 dBm";
  EXPECT_GT(at(27), 90);
}

TEST_F(LinkMapperComponentTest, ACardWithoutItsNetworkIsTheWorstSignal) {
  start();
  drive(1);
  x_m_ += 0.4;
  tell_pose();
  measure(nan, 1);
  bus_.run_for(seconds(3));
  EXPECT_EQ(lines(), 3U);
}

TEST_F(LinkMapperComponentTest, LearnsOnlyWhereThePoseIsWellKnown) {
  start();
  drive(30, 0.5);
  tell_pose(nan);
  measure(-50);
  bus_.run_for(seconds(3));
  x_m_ = 0;
  tell_pose();
  bus_.run_for(seconds(1));
  measure(-50);  // where it was a second ago
  bus_.run_for(seconds(0.1));
  tell_pose();
  measure(nan);
  bus_.run_for(seconds(3));
  EXPECT_FALSE(std::filesystem::exists(file_));
  drive(1);
  bus_.run_for(seconds(3));
  EXPECT_EQ(lines(), 2U);
}

TEST_F(LinkMapperComponentTest, GoesOnWithWhatWasMeasuredBefore) {
  start();
  drive(20);
  stop();
  EXPECT_EQ(lines(), 21U) << "saved at the end";
  x_m_ = 0;
  start();
  bus_.run_for(seconds(3));
  EXPECT_FALSE(grids_.take().empty());
  x_m_ = 20;
  drive(1);
  stop();
  EXPECT_EQ(lines(), 22U);
}

TEST_F(LinkMapperComponentTest, RefusesAFileOfSomethingElse) {
  std::ofstream(file_) << "a,b\n1,2\n";
  EXPECT_THROW(LinkMapperComponent(context_, params_), ConfigError);
  EXPECT_EQ(lines(), 2U);
}

TEST_F(LinkMapperComponentTest, TriesAgainWhereTheFileCannotBeWritten) {
  params_.map_name = (folder_ / "nowhere" / "floor").string();
  start();
  drive(20);
  bus_.run_for(seconds(4));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  std::filesystem::create_directory(folder_ / "nowhere");
  bus_.run_for(seconds(4));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "nowhere" / "floor.signal.csv"));
}

}  // namespace
}  // namespace tocsin
