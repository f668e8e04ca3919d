// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "bag/bag_reader.hpp"
#include "foundation/temporary_folder.hpp"
#include "recorder/recorder_component.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

/// A recorder that is told when to record.
class RecordNowTest : public ::testing::Test {
 protected:
  RecordNowTest() { params_.recording = false; }
  void make() {
    sut_ = std::make_unique<RecorderComponent>(context_, params_);
    bus_.add(*sut_);
    bus_.run_for(seconds(1));
  }
  void tell(bool recording) {
    params_.recording = recording;
    sut_->post([this] { sut_->set_parameters(params_); });
    bus_.run_for(seconds(1));
  }
  void publish(std::uint64_t id) {
    tocsin_msgs::msg::Goal goal;
    goal.id(id);
    bus_.publish<topic::Goal>(goal);
    bus_.run_for(seconds(1));
  }
  [[nodiscard]] std::uint64_t messages_in(const std::string& bag) const {
    const bag::BagReader reader(folder_.path("run/gcs/" + bag));
    EXPECT_TRUE(reader.damaged().empty()) << bag;
    return reader.about().count;
  }
  [[nodiscard]] std::size_t ports() const { return sut_->port_health().size(); }

  const TemporaryFolder folder_;
  SimBus bus_;
  Context context_ = Context(bus_, "recorder", Role::gcs).with_run_dir(folder_.path("run"));
  RecorderComponent::Params params_;
  std::unique_ptr<RecorderComponent> sut_;
};

TEST_F(RecordNowTest, BeforeItIsToldItReadsNothingAndMakesNoFile) {
  make();
  publish(1);
  EXPECT_EQ(ports(), 0U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run")));
}

TEST_F(RecordNowTest, RecordsFromWhenItIsToldUntilItIsToldOtherwise) {
  make();
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
  make();
  for (std::uint64_t id = 1; id <= 3; ++id) {
    tell(true);
    publish(id);
    tell(false);
  }
  for (const char* bag : {"bag", "bag_2", "bag_3"}) EXPECT_EQ(messages_in(bag), 1U);
}

TEST_F(RecordNowTest, AStateOfBeforeIsInTheRecordingFromItsBeginning) {
  make();
  bus_.publish<topic::MissionStatus>({});
  bus_.run_for(seconds(60));
  tell(true);
  publish(1);
  tell(false);
  const bag::BagReader reader(folder_.path("run/gcs/bag"));
  EXPECT_EQ(reader.about().count, 2U);
  EXPECT_LT(reader.about().duration_ns, 5'000'000'000);
}

TEST_F(RecordNowTest, ToldTwiceTheRecordingGoesOn) {
  make();
  tell(true);
  publish(1);
  tell(true);
  publish(2);
  tell(false);
  EXPECT_EQ(messages_in("bag"), 2U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("run/gcs/bag_2")));
}

TEST_F(RecordNowTest, WhatCannotBeginIsSaidOnceAndTriedAgain) {
  make();
  std::ofstream(folder_.path("run")) << "a file where the folder would be";
  ::testing::internal::CaptureStderr();
  tell(true);
  bus_.run_for(seconds(10));
  const std::string log = ::testing::internal::GetCapturedStderr();
  const auto first = log.find("does not record: ");
  ASSERT_NE(first, std::string::npos) << log;
  EXPECT_EQ(log.find("does not record: ", first + 1), std::string::npos);
  std::filesystem::remove(folder_.path("run"));
  bus_.run_for(seconds(3));
  publish(1);
  tell(false);
  EXPECT_EQ(messages_in("bag"), 1U);
}

}  // namespace
}  // namespace tocsin
