// SPDX-License-Identifier: Apache-2.0
#include "scan_input/scan_input.hpp"

#include <gtest/gtest.h>

#include "foundation/numbers.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class Looker final : public Component {
 public:
  explicit Looker(Context& context) : Component(context) {}
  void tick(Time) override {
    if (auto turn = scan.take({})) seen = std::move(*turn);
  }
  ScanInput scan{*this};
  std::optional<ScanInput::Turn> seen;
};

class ScanInputTest : public ::testing::Test {
 protected:
  ScanInputTest() { bus_.add(sut_); }
  void tell_mount(const std::string& frame, double x_m, double yaw_rad) {
    topic::TfStatic::Message message;
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id(frame);
    transform.transform().translation().x(x_m);
    const auto turned = geometry::quaternion_of(yaw_rad);
    transform.transform().rotation().z(turned.z);
    transform.transform().rotation().w(turned.w);
    message.transforms().push_back(transform);
    bus_.publish<topic::TfStatic>(message);
  }
  void scan(std::vector<float> ranges_m) {
    topic::Scan::Message message;
    message.header().frame_id("laser");
    message.header().stamp().sec(7);
    message.header().stamp().nanosec(5);
    message.angle_increment(static_cast<float>(pi / 2));
    message.range_max(10);
    message.ranges(std::move(ranges_m));
    bus_.publish<topic::Scan>(message);
    bus_.run_for(seconds(0.1));
  }

  SimBus bus_;
  Context context_{bus_, "looker", Role::uxv};
  Looker sut_{context_};
};

TEST_F(ScanInputTest, GivesTheNewestTurnAsSeenFromTheVehicle) {
  tell_mount("laser", 0.1, pi);
  scan({1, 2});
  ASSERT_TRUE(sut_.seen);
  EXPECT_EQ(sut_.seen->stamp_ns, 7'000'000'005);
  ASSERT_EQ(sut_.seen->scan.hits.size(), 2U);
  EXPECT_NEAR(sut_.seen->scan.hits[0].x_m, -0.9, 1e-6) << "the laser looks back";
  EXPECT_NEAR(sut_.seen->scan.hits[1].y_m, -2, 1e-6);
}

TEST_F(ScanInputTest, UsesNoScanBeforeItKnowsWhereTheLaserSits) {
  tell_mount("camera", 0, 0);
  scan({1});
  EXPECT_FALSE(sut_.seen);
  tell_mount("laser", 0, 0);
  scan({1});
  EXPECT_TRUE(sut_.seen);
}

TEST_F(ScanInputTest, PassesOverWhatIsNoScanAndAMountThatIsNone) {
  tell_mount("laser", nan, 0);
  scan({1});
  EXPECT_FALSE(sut_.seen) << "no place";
  tell_mount("laser", 0, 0);
  scan({});
  EXPECT_FALSE(sut_.seen) << "no readings";
  scan({1});
  EXPECT_TRUE(sut_.seen);
}

}  // namespace
}  // namespace tocsin
