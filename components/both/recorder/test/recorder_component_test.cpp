// SPDX-License-Identifier: Apache-2.0
#include "recorder/recorder_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "bag/bag_reader.hpp"
#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct FilledInGoal {
  using Message = topic::Goal::Message;
  static constexpr TopicInfo info{"goal/backfilled", "event", Scope::host};
};

class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest() : directory_(::testing::TempDir() + "/recorder_" + std::to_string(getpid())) {
    std::filesystem::remove_all(directory_);
  }
  ~RecorderTest() override { std::filesystem::remove_all(directory_); }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(directory_ + "/gcs/" + name).rdbuf();
    return text.str();
  }
  void record_a_goal(std::uint64_t id) {
    SimBus bus;
    Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
    RecorderComponent sut(context, {});
    bus.add(sut);
    tocsin_msgs::msg::Goal goal;
    goal.id(id);
    bus.publish<topic::Goal>(goal);
    bus.run_for(seconds(1));
  }
  std::string directory_;
};

TEST_F(RecorderTest, WritesARowPerSample) {
  record_a_goal(7);
  const std::string messages = read("messages.csv");
  EXPECT_THAT(messages, StartsWith("receive_s,send_s,topic,writer,sequence,bytes\n"));
  EXPECT_THAT(messages, HasSubstr("1767225600.000000000,1767225600.000000000,goal,1,1,"));
}

TEST_F(RecorderTest, WritesTheFieldsOfATopic) {
  record_a_goal(7);
  EXPECT_THAT(read("goal.csv"),
              StartsWith("receive_s,send_s,sequence,stamp.sec,stamp.nanosec,id,"));
  EXPECT_THAT(read("goal.csv"), HasSubstr(",0,0,7,"));
}

TEST_F(RecorderTest, RecordsATopicOfItsHostByName) {
  RecorderComponent::Params params;
  params.topics = {"odom"};
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  RecorderComponent sut(context, params);
  bus.add(sut);
  nav_msgs::msg::Odometry odometry;
  odometry.pose().pose().position().x(3.5);
  bus.publish<topic::Odom>(odometry);
  bus.publish<topic::Goal>({});
  bus.run_for(seconds(1));
  EXPECT_THAT(read("odom.csv"), HasSubstr(",3.5,"));
  EXPECT_THAT(read("messages.csv"), HasSubstr(",goal,"));
}

/// A topic that no library states.
struct Remark {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"crew/remark", "event", Scope::host};
};

TEST_F(RecorderTest, TellsWhatWasFilledInFromWhatCrossedLive) {
  RecorderComponent::Params params;
  params.backfilled = true;
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  RecorderComponent sut(context, params);
  bus.add(sut);
  tocsin_msgs::msg::Goal goal;
  goal.id(7);
  bus.publish<topic::Goal>(goal);
  goal.id(6);
  bus.publish<FilledInGoal>(goal);
  bus.run_for(seconds(1));
  EXPECT_THAT(read("goal.csv"), HasSubstr(",0,0,7,"));
  EXPECT_THAT(read("goal.csv"), Not(HasSubstr(",0,0,6,")));
  EXPECT_THAT(read("goal.backfilled.csv"), HasSubstr(",0,0,6,"));
  EXPECT_THAT(read("messages.csv"), HasSubstr(",goal/backfilled,"));
}

TEST_F(RecorderTest, RecordsATopicThatNobodyKnowsByItsType) {
  RecorderComponent::Params params;
  params.link_topics = false;
  params.topics = {"/crew/remark std_msgs/msg/String event"};
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  RecorderComponent sut(context, params);
  bus.add(sut);
  std_msgs::msg::String remark;
  remark.data("fog ahead");
  bus.publish<Remark>(remark);
  bus.publish<topic::Goal>({});
  bus.run_for(seconds(1));
  EXPECT_THAT(read("crew.remark.csv"), HasSubstr(",fog ahead\n"));
  EXPECT_EQ(read("messages.csv").find(",goal,"), std::string::npos);
}

TEST_F(RecorderTest, ATopicThatNobodyKnowsIsNamedInTheError) {
  RecorderComponent::Params params;
  params.topics = {"sensors/cor"};
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  try {
    const RecorderComponent sut(context, params);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), StartsWith("recorder.topics: 'sensors/cor' is not a known topic"));
  }
}

TEST_F(RecorderTest, ARestartedRecorderAppends) {
  record_a_goal(7);
  record_a_goal(8);
  const std::string goals = read("goal.csv");
  EXPECT_THAT(goals, HasSubstr(",0,0,7,"));
  EXPECT_THAT(goals, HasSubstr(",0,0,8,"));
  EXPECT_EQ(goals.find("receive_s", 1), std::string::npos) << "two headers";
}

TEST_F(RecorderTest, HalfARowLeftByAKilledRecorderIsEnded) {
  record_a_goal(7);
  std::ofstream(directory_ + "/gcs/goal.csv", std::ios::app) << "17672,half";
  record_a_goal(8);
  EXPECT_THAT(read("goal.csv"), HasSubstr("17672,half\n1767225600"));
}

TEST_F(RecorderTest, SaysOnceThatTheDiskIsFullAndOnceThatItIsNot) {
  std::filesystem::create_directories(directory_ + "/gcs");
  std::filesystem::create_symlink("/dev/full", directory_ + "/gcs/goal.csv");
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  RecorderComponent sut(context, {});
  bus.add(sut);
  ::testing::internal::CaptureStderr();
  for (int i = 0; i < 5; ++i) {
    bus.publish<topic::Goal>({});
    bus.run_for(seconds(0.5));
  }
  bus.run_for(seconds(5));
  const std::string log = ::testing::internal::GetCapturedStderr();
  const auto first = log.find("rows are being lost");
  ASSERT_NE(first, std::string::npos) << log;
  EXPECT_EQ(log.find("rows are being lost", first + 1), std::string::npos);
  EXPECT_THAT(log, HasSubstr("can be written again; 6 rows were lost since the start"));
}

TEST_F(RecorderTest, WritesABagBesideTheCsvFiles) {
  record_a_goal(7);
  const bag::BagReader reader(directory_ + "/gcs/bag");
  EXPECT_EQ(reader.about().count, 1U);
  EXPECT_TRUE(reader.damaged().empty());
}

TEST_F(RecorderTest, WritesOneOfTheTwoWhenAsked) {
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir(directory_);
  RecorderComponent::Params params;
  params.csv = false;
  { const RecorderComponent sut(context, params); }
  EXPECT_TRUE(std::filesystem::exists(directory_ + "/gcs/bag"));
  EXPECT_FALSE(std::filesystem::exists(directory_ + "/gcs/messages.csv"));
  params.csv = true;
  params.bag = false;
  { const RecorderComponent sut(context, params); }
  EXPECT_TRUE(std::filesystem::exists(directory_ + "/gcs/messages.csv"));
  EXPECT_FALSE(std::filesystem::exists(directory_ + "/gcs/bag_2"));
  params.csv = false;
  EXPECT_THROW((RecorderComponent{context, params}), ConfigError);
}

TEST_F(RecorderTest, AFolderThatCannotBeMadeIsAConfigError) {
  SimBus bus;
  Context context = Context(bus, "recorder", Role::gcs).with_run_dir("/proc/nowhere");
  EXPECT_THROW((RecorderComponent{context, {}}), ConfigError);
}

}  // namespace
}  // namespace tocsin
