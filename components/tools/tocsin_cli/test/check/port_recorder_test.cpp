// SPDX-License-Identifier: Apache-2.0
#include "port_recorder.hpp"

#include <gtest/gtest.h>

#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::check {
namespace {

class Toy : public Component {
 public:
  explicit Toy(Context& context) : Component(context) {}
  void tick(Time now) override { (void)now; }

 private:
  Input<topic::Odom> odom_{*this};
  Input<topic::Odom> again_{*this};
  Output<topic::Location> location_{*this};
};

TEST(PortRecorder, WritesDownEachPortOnce) {
  PortRecorder sut;
  Context context{sut, "toy", Role::uxv};
  const Toy toy(context);
  ASSERT_EQ(sut.ports().size(), 2U);
  EXPECT_EQ(sut.ports()[0].topic, "odom");
  EXPECT_FALSE(sut.ports()[0].writes);
  EXPECT_EQ(sut.ports()[0].type, "nav_msgs::msg::dds_::Odometry_");
  EXPECT_EQ(sut.ports()[1].topic, "location");
  EXPECT_TRUE(sut.ports()[1].writes);
  EXPECT_EQ(sut.ports()[1].scope, Scope::link);
}

class Choosy : public Component {
 public:
  explicit Choosy(Context& context) : Component(context) {}
  void tick(Time now) override { (void)now; }

 private:
  OptionalInput<topic::Odom> odom_{*this};
  OptionalInput<topic::Goal> goal_{*this};
  Input<topic::Goal> needed_{*this};
};

struct NullReceiver final : Receiver {
  void receive(const Sample&) override {}
};

/// The emergency stop hears every writer; a second reader of the same component may ask for more.
TEST(PortRecorder, KeepsWhatTheMoreDemandingOfTwoReadersRequests) {
  const TypeInfo& type = type_info<topic::EmergencyStop::Message>();
  TopicInfo anything = topic::EmergencyStop::info;
  TopicInfo profile = anything;
  profile.requests = Requests::profile;
  for (const bool demanding_first : {false, true}) {
    PortRecorder sut;
    NullReceiver receiver;
    (void)sut.subscribe({demanding_first ? profile : anything, &type}, receiver);
    (void)sut.subscribe({demanding_first ? anything : profile, &type}, receiver);
    ASSERT_EQ(sut.ports().size(), 1U);
    EXPECT_EQ(sut.ports()[0].requests, Requests::profile);
  }
}

TEST(PortRecorder, KeepsEndsApartThatDisagreeOnTheirTopic) {
  PortRecorder sut;
  const TopicInfo status{"status", "state", Scope::link};
  const TypeInfo& text = type_info<std_msgs::msg::String>();
  (void)sut.advertise({status, &text});
  (void)sut.advertise({status, &text});
  ASSERT_EQ(sut.ports().size(), 1U);
  (void)sut.advertise({status, &type_info<std_msgs::msg::Bool>()});
  (void)sut.advertise({{"status", "event", Scope::link}, &text});
  (void)sut.advertise({{"status", "state", Scope::host}, &text});
  ASSERT_EQ(sut.ports().size(), 4U) << "what is written down nowhere can be found by nobody";
  EXPECT_EQ(sut.ports()[1].type, "std_msgs::msg::dds_::Bool_");
  EXPECT_EQ(sut.ports()[2].qos, "event");
  EXPECT_EQ(sut.ports()[3].scope, Scope::host);
}

}  // namespace
}  // namespace tocsin::check
