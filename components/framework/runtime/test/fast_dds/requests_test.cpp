// SPDX-License-Identifier: Apache-2.0
// Who is heard by a reader that asks for nothing, and what it learns of them. Real Fast DDS on
// loopback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using Bool = std_msgs::msg::Bool;
using ::testing::HasSubstr;

const Endpoint stop{{"stop", "state", Scope::host, Requests::anything}, &type_info<Bool>()};
const char* const state = "state: {reliability: reliable, durability: transient_local}\n";

std::shared_ptr<const Bool> pressed() {
  auto word = std::make_shared<Bool>();
  word->data(true);
  return word;
}

class RequestsTest : public ::testing::Test {
 protected:
  static int domain() {
    static int next = 64;
    return ++next;
  }
  /// Repeats the word until somebody has heard it.
  static bool say(Publication& writer, Samples& heard) {
    return eventually([&] {
      EXPECT_EQ(writer.write(pressed()), Status::ok);
      return !heard.all().empty();
    });
  }

  const int domain_ = domain();
  const std::unique_ptr<Bus> vehicle_ = make_test_bus(domain_, state);
  Samples heard_;
  const std::unique_ptr<Subscription> listener_ = vehicle_->subscribe(stop, heard_);
};

TEST_F(RequestsTest, AReaderThatAsksForNothingHearsEveryWriter) {
  for (const char* offered :
       {"state: {reliability: reliable}\n", "state: {reliability: best_effort}\n",
        "state: {reliability: reliable, durability: transient_local}\n",
        "state: {reliability: reliable, deadline_s: 5, liveliness: manual_by_topic, "
        "liveliness_lease_s: 9}\n"}) {
    heard_.clear();
    const auto peer = make_test_bus(domain_, offered);
    const auto writer = peer->advertise(stop);
    EXPECT_TRUE(say(*writer, heard_)) << offered;
  }
}

TEST_F(RequestsTest, TheOrdinaryReaderOfAStateDoesNotHearAVolatileWriter) {
  const Endpoint ordinary{{"ordinary", "state", Scope::host}, &type_info<Bool>()};
  Samples none;
  const auto reader = vehicle_->subscribe(ordinary, none);
  const auto peer = make_test_bus(domain_, "state: {reliability: reliable}\n");
  const auto writer = peer->advertise(ordinary);
  EXPECT_TRUE(
      eventually([&] { return health_of(*vehicle_, "ordinary", false).incompatible_qos >= 1; }));
  EXPECT_EQ(health_of(*vehicle_, "stop", false).incompatible_qos, 0U);
}

TEST_F(RequestsTest, TheBuiltInProfilesReachAProfileWithAPartition) {
  const auto partitioned =
      make_test_bus(domain_, "state: {durability: transient_local, partition: [north]}\n");
  Samples north;
  const auto reader = partitioned->subscribe(stop, north);
  BusOptions options;
  options.name = "built_in";
  options.host_domain = domain_;
  const auto peer = make_fast_dds_bus(options);
  const auto writer = peer->advertise(stop);
  EXPECT_TRUE(say(*writer, north));
  EXPECT_TRUE(say(*writer, heard_));
}

TEST_F(RequestsTest, TellsWhoWroteAndWhetherItIsStillThere) {
  const auto peer = make_test_bus(domain_, "state: {user_data: mast=4}\n");
  Endpoint station = stop;
  station.user_data = "party=station;";
  auto writer = peer->advertise(station);
  ASSERT_TRUE(say(*writer, heard_));
  const std::uint64_t source = heard_.all().front().source;
  const auto known = listener_->writer(source);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->name, "test");
  EXPECT_THAT(known->user_data, HasSubstr("mast=4;"));
  EXPECT_THAT(known->user_data, HasSubstr("party=station;"));
  EXPECT_FALSE(listener_->writer(source + 1));
  writer.reset();
  EXPECT_TRUE(eventually([&] { return !listener_->writer(source); }));
}

TEST_F(RequestsTest, TellsOfAWriterOfItsOwnProcess) {
  Endpoint station = stop;
  station.user_data = "party=station;";
  auto writer = vehicle_->advertise(station);
  ASSERT_TRUE(say(*writer, heard_));
  const std::uint64_t source = heard_.all().front().source;
  EXPECT_THAT(listener_->writer(source)->user_data, HasSubstr("party=station;"));
  writer.reset();
  EXPECT_FALSE(listener_->writer(source));
}

TEST_F(RequestsTest, RefusesTwoWritersOfOneProcessThatAnnounceDifferentThings) {
  Endpoint station = stop;
  station.user_data = "party=station;";
  auto first = vehicle_->advertise(station);
  const auto second = vehicle_->advertise(station);
  try {
    const auto third = vehicle_->advertise(stop);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("topic stop: two writers of one process announce"));
  }
}

}  // namespace
}  // namespace tocsin
