// SPDX-License-Identifier: Apache-2.0
#include "recorder/recorder_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bag/bag_reader.hpp"
#include "csv_tables/bag_tables.hpp"
#include "foundation/error.hpp"
#include "foundation/small_disk.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct BackfilledGoal {
  using Message = topic::Goal::Message;
  static constexpr TopicInfo info{"goal/backfilled", "event", Scope::host};
};

/// A topic that no library states.
struct Remark {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"crew/remark", "event", Scope::host};
};

class RecorderTest : public ::testing::Test {
 protected:
  void make() {
    sut_.emplace(context_, params_);
    bus_.add(*sut_);
  }
  template <class Topic = topic::Goal>
  void publish_goal(std::uint64_t id) {
    tocsin_msgs::msg::Goal goal;
    goal.id(id);
    bus_.publish<Topic>(goal);
  }
  /// The tables of what was recorded, once the recorder has flushed.
  [[nodiscard]] BagTables tables() {
    bus_.run_for(seconds(1));
    return BagTables(recorded_bags(folder_.path("gcs")));
  }

  const TemporaryFolder folder_;
  SimBus bus_;
  Context context_ = Context(bus_, "recorder", Role::gcs).with_run_dir(folder_.path());
  RecorderComponent::Params params_;
  std::optional<RecorderComponent> sut_;
};

TEST_F(RecorderTest, WritesEverySampleOfTheLinkWithItsTimesWriterAndNumber) {
  make();
  publish_goal(7);
  const BagTables sut = tables();
  EXPECT_THAT(sut.messages(), HasSubstr("1767225600.000000000,1767225600.000000000,goal,1,1,"));
  EXPECT_THAT(sut.of("goal"), HasSubstr(",0,0,7,"));
}

TEST_F(RecorderTest, RecordsATopicOfItsHostByName) {
  params_.topics = {"odom"};
  make();
  nav_msgs::msg::Odometry odometry;
  odometry.pose().pose().position().x(3.5);
  bus_.publish<topic::Odom>(odometry);
  publish_goal(1);
  const BagTables sut = tables();
  EXPECT_THAT(sut.of("odom"), HasSubstr(",3.5,"));
  EXPECT_THAT(sut.messages(), HasSubstr(",goal,"));
}

TEST_F(RecorderTest, TellsWhatWasBackfilledFromWhatCrossedLive) {
  params_.backfilled = true;
  make();
  publish_goal(7);
  publish_goal<BackfilledGoal>(6);
  const BagTables sut = tables();
  EXPECT_THAT(sut.of("goal"), AllOf(HasSubstr(",0,0,7,"), Not(HasSubstr(",0,0,6,"))));
  EXPECT_THAT(sut.of("goal/backfilled"), HasSubstr(",0,0,6,"));
}

TEST_F(RecorderTest, RecordsATopicThatNobodyKnowsByItsType) {
  params_.link_topics = false;
  params_.topics = {"/crew/remark std_msgs/msg/String event"};
  make();
  std_msgs::msg::String remark;
  remark.data("fog ahead");
  bus_.publish<Remark>(remark);
  publish_goal(1);
  const BagTables sut = tables();
  EXPECT_THAT(sut.of("crew/remark"), EndsWith(",fog ahead\n"));
  EXPECT_THAT(sut.messages(), Not(HasSubstr(",goal,")));
}

TEST_F(RecorderTest, SaysOnceThatTheDiskIsFullAndOnceThatItIsNot) {
  make();
  bus_.run_for(seconds(1));
  ::testing::internal::CaptureStderr();
  {
    const SmallDisk disk(std::filesystem::file_size(folder_.path("gcs/bag/bag_0.mcap")));
    for (int i = 0; i < 5; ++i) {
      publish_goal(1);
      bus_.run_for(seconds(0.5));
    }
  }
  bus_.run_for(seconds(5));
  const std::string log = ::testing::internal::GetCapturedStderr();
  const auto first = log.find("messages are being lost");
  ASSERT_NE(first, std::string::npos) << log;
  EXPECT_EQ(log.find("messages are being lost", first + 1), std::string::npos);
  EXPECT_THAT(log, HasSubstr("can be written again; 5 messages were lost since the start"));
}

TEST_F(RecorderTest, AFolderThatCannotBeMadeIsAConfigError) {
  context_.run_dir = "/proc/nowhere";
  EXPECT_THROW(make(), ConfigError);
}

/// A recorder that is told when to record.
class RecordNowTest : public RecorderTest {
 protected:
  RecordNowTest() {
    params_.recording = false;
    make();
    bus_.run_for(seconds(1));
  }
  void tell(bool recording) {
    params_.recording = recording;
    sut_->post([this] { sut_->set_parameters(params_); });
    bus_.run_for(seconds(1));
  }
  void publish(std::uint64_t id) {
    publish_goal(id);
    bus_.run_for(seconds(1));
  }
  [[nodiscard]] std::uint64_t messages_in(const std::string& bag) const {
    const bag::BagReader reader(folder_.path("gcs/" + bag));
    EXPECT_TRUE(reader.damaged().empty()) << bag;
    return reader.about().count;
  }
  [[nodiscard]] std::size_t ports() const { return sut_->port_health().size(); }
};

TEST_F(RecordNowTest, BeforeItIsToldItReadsNothingAndMakesNoFile) {
  publish(1);
  EXPECT_EQ(ports(), 0U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("gcs")));
}

TEST_F(RecordNowTest, RecordsFromWhenItIsToldUntilItIsToldOtherwise) {
  publish(1);
  tell(true);
  publish(2);
  publish(3);
  tell(false);
  publish(4);
  EXPECT_EQ(ports(), 0U);
  EXPECT_EQ(messages_in("bag"), 2U);
}

TEST_F(RecordNowTest, EachRecordingIsAWholeBagOfItsOwn) {
  for (std::uint64_t id = 1; id <= 3; ++id) {
    tell(true);
    publish(id);
    tell(false);
  }
  for (const char* bag : {"bag", "bag_2", "bag_3"}) EXPECT_EQ(messages_in(bag), 1U);
}

TEST_F(RecordNowTest, AStateOfBeforeIsInTheRecordingFromItsBeginning) {
  bus_.publish<topic::MissionStatus>({});
  bus_.run_for(seconds(60));
  tell(true);
  publish(1);
  tell(false);
  const bag::BagReader reader(folder_.path("gcs/bag"));
  EXPECT_EQ(reader.about().count, 2U);
  EXPECT_LT(reader.about().duration_ns, 5'000'000'000);
}

TEST_F(RecordNowTest, ToldTwiceTheRecordingGoesOn) {
  tell(true);
  publish(1);
  tell(true);
  publish(2);
  tell(false);
  EXPECT_EQ(messages_in("bag"), 2U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("gcs/bag_2")));
}

TEST_F(RecordNowTest, WhatCannotBeginIsSaidOnceAndTriedAgain) {
  std::ofstream(folder_.path("gcs")) << "a file where the folder would be";
  ::testing::internal::CaptureStderr();
  tell(true);
  bus_.run_for(seconds(10));
  const std::string log = ::testing::internal::GetCapturedStderr();
  const auto first = log.find("does not record: ");
  ASSERT_NE(first, std::string::npos) << log;
  EXPECT_EQ(log.find("does not record: ", first + 1), std::string::npos);
  std::filesystem::remove(folder_.path("gcs"));
  bus_.run_for(seconds(3));
  publish(1);
  tell(false);
  EXPECT_EQ(messages_in("bag"), 1U);
}

}  // namespace
}  // namespace tocsin
