// SPDX-License-Identifier: Apache-2.0
#include "modelled_localiser/modelled_localiser_component.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "geometry/pose_message.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class Truth final : public TruePose {
 public:
  explicit Truth(const geometry::Pose& pose) : pose_(pose) {}
  geometry::Pose read() override { return pose_; }

 private:
  const geometry::Pose& pose_;
};

class ModelledLocaliserTest : public ::testing::Test {
 protected:
  [[nodiscard]] Computer with_truth() const {
    Computer computer;
    computer.devices.add<TruePose>([this](const std::string&, const Devices::Readable&) {
      return std::make_unique<Truth>(truth_);
    });
    return computer;
  }
  void run(double s) {
    for (int i = 0; i < std::lround(s * 50); ++i) {
      topic::Odom::Message odom;
      odom.header().stamp(builtin_interfaces::msg::Time());
      odom.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>({1, 0, 0}));
      bus_.publish<topic::Odom>(odom);
      sut_.tick(bus_.now());
      bus_.run_for(seconds(0.02));
      for (auto& pose : poses_.take()) all_.push_back(pose);
      for (auto& transform : transforms_.take()) frames_ += transform.transforms().size();
    }
  }
  geometry::Pose truth_{4, 5, 0};
  Computer computer_ = with_truth();
  SimBus bus_;
  Context context_ = Context(bus_, "modelled_localiser", Role::uxv).with_computer(computer_);
  ModelledLocaliserComponent sut_{context_, {}};
  SimReader<topic::AmclPose> poses_{bus_};
  SimReader<topic::Tf> transforms_{bus_};
  std::vector<topic::AmclPose::Message> all_;
  std::size_t frames_ = 0;
};

TEST_F(ModelledLocaliserTest, TellsTheTruthButForItsErrorAtItsRate) {
  run(10);
  EXPECT_NEAR(static_cast<double>(all_.size()), 55, 3);
  EXPECT_EQ(frames_, all_.size());
  const geometry::Pose pose = geometry::pose_in(all_.back().pose().pose());
  EXPECT_NEAR(pose.x_m, 4, 0.1);
  EXPECT_NE(pose.x_m, 4);
  EXPECT_LT(all_.back().pose().covariance()[0], 0.01);
}

TEST_F(ModelledLocaliserTest, SaysThatItDoesNotKnowWhenTheVehicleWasCarriedOff) {
  run(1);
  truth_ = {8, 5, 0};
  frames_ = 0;
  run(1);
  EXPECT_GE(all_.back().pose().covariance()[0], 1);
  EXPECT_EQ(frames_, 0U);
  run(6);
  EXPECT_NEAR(geometry::pose_in(all_.back().pose().pose()).x_m, 8, 0.1);
}

TEST(ModelledLocaliser, IsNotForARealVehicle) {
  SimBus bus;
  Computer computer;
  Context context = Context(bus, "modelled_localiser", Role::uxv).with_computer(computer);
  EXPECT_THROW(ModelledLocaliserComponent(context, {}), ConfigError);
}

}  // namespace
}  // namespace tocsin
