// SPDX-License-Identifier: Apache-2.0
#include "recorder/bag_recording.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "bag/bag_reader.hpp"
#include "foundation/error.hpp"
#include "foundation/free_space.hpp"
#include "foundation/small_disk.hpp"
#include "foundation/temporary_folder.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using String = std_msgs::msg::String;

class BagRecordingTest : public ::testing::Test {
 protected:
  [[nodiscard]] static ChosenTopic topic(const std::string& name, const char* qos = "sensor") {
    return {make_topic_info(name, qos, Scope::host), &type_info<String>()};
  }
  [[nodiscard]] static Sample sample(const std::string& text) {
    auto message = std::make_shared<String>();
    message->data(text);
    Sample made;
    made.message = message;
    made.sent_wall_ns = 1'500'000'000;
    made.received_wall_ns = 2'000'000'001;
    made.sequence = 4;
    made.source = 9;
    return made;
  }
  const TemporaryFolder folder_;
};

TEST_F(BagRecordingTest, KeepsMessagesAsTheyAreOnTheWire) {
  {
    BagRecording sut(folder_.path(), mcap::Compression::none);
    const std::size_t number = sut.add(topic("a/b"));
    sut.write(number, sample("hello"));
    sut.flush();
    EXPECT_EQ(sut.lost(), 0U);
  }
  bag::BagReader reader(folder_.path("bag"));
  const auto& about = reader.topics().at(0).topic;
  EXPECT_EQ(about.name, "/a/b");
  EXPECT_EQ(about.type, "std_msgs/msg/String");
  EXPECT_EQ(about.definition, "string data\n");
  const auto stream = reader.messages();
  const auto one = stream->next();
  ASSERT_TRUE(one);
  EXPECT_EQ(one->message.sequence, 4U);
  EXPECT_EQ(one->message.log_time_ns, 2'000'000'001);
  EXPECT_EQ(one->message.publish_time_ns, 1'500'000'000);
  EXPECT_EQ(one->message.writer, 9U);
  String message;
  ASSERT_TRUE(type_info<String>().deserialize(one->message.data, one->message.size, &message));
  EXPECT_EQ(message.data(), "hello");
}

TEST_F(BagRecordingTest, TellsWhatTheBuiltInProfilesOffer) {
  {
    BagRecording sut(folder_.path(), mcap::Compression::none);
    (void)sut.add(topic("mode", "state"));
    (void)sut.add(topic("other", "my_own"));
  }
  const bag::BagReader reader(folder_.path("bag"));
  const auto& state = reader.topics().at(0).topic.offered_qos.at(0);
  EXPECT_EQ(state.durability, bag::OfferedQos::Durability::transient_local);
  EXPECT_EQ(state.depth, 1);
  EXPECT_TRUE(reader.topics().at(1).topic.offered_qos.empty());
}

TEST_F(BagRecordingTest, ARestartedRecorderHasABagOfItsOwn) {
  for (int i = 0; i < 3; ++i) {
    BagRecording sut(folder_.path(), mcap::Compression::none);
    sut.write(sut.add(topic("a")), sample("x"));
  }
  for (const char* name : {"bag", "bag_2", "bag_3"}) {
    EXPECT_EQ(bag::BagReader(folder_.path(name)).about().count, 1U) << name;
  }
}

TEST_F(BagRecordingTest, CountsWhatAFullDiskTakes) {
  BagRecording sut(folder_.path(), mcap::Compression::none);
  const std::size_t number = sut.add(topic("a"));
  sut.flush();
  {
    const SmallDisk disk(std::filesystem::file_size(folder_.path("bag/bag_0.mcap")));
    sut.write(number, sample("lost"));
    sut.flush();
    EXPECT_EQ(sut.lost(), 1U);
  }
  sut.write(number, sample("kept"));
  sut.flush();
  EXPECT_EQ(sut.lost(), 1U);
  EXPECT_EQ(bag::BagReader(folder_.path("bag")).about().count, 1U);
}

TEST_F(BagRecordingTest, LeavesAShareOfTheDiskToOthers) {
  const auto written_and_lost = [&](const KeptFree& kept) {
    BagRecording sut(folder_.path(), mcap::Compression::none, kept);
    const std::size_t number = sut.add(topic("a"));
    sut.write(number, sample("one"));
    sut.flush();
    sut.write(number, sample("another"));
    sut.flush();
    return sut.lost();
  };
  const auto all = std::numeric_limits<std::uint64_t>::max();
  const double free = free_share(folder_.path()).value();
  EXPECT_EQ(written_and_lost({0.5 * free, all}), 0U);
  EXPECT_EQ(bag::BagReader(folder_.path("bag")).about().count, 2U);
  EXPECT_EQ(written_and_lost({1, all}), 2U);  // no disk is wholly free
  EXPECT_EQ(bag::BagReader(folder_.path("bag_2")).about().count, 0U);
  EXPECT_EQ(written_and_lost({1, 1}), 0U);  // of a large one no more than that
}

TEST_F(BagRecordingTest, PacksChunks) {
  {
    BagRecording sut(folder_.path(), mcap::Compression::zstd);
    sut.write(sut.add(topic("a")), sample(std::string(10'000, 'x')));
  }
  const mcap::Reader file(folder_.path("bag/bag_0.mcap"));
  EXPECT_EQ(file.summary().chunks.at(0).compression, "zstd");
}

TEST_F(BagRecordingTest, AFolderThatCannotBeMadeIsAConfigError) {
  EXPECT_THROW(BagRecording("/proc/nowhere", mcap::Compression::none), ConfigError);
}

}  // namespace
}  // namespace tocsin
