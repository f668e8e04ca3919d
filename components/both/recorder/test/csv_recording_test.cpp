// SPDX-License-Identifier: Apache-2.0
#include "recorder/csv_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class CsvRecordingTest : public ::testing::Test {
 protected:
  [[nodiscard]] static ChosenTopic topic(const std::string& name) {
    return {make_topic_info(name, "sensor", Scope::host), &type_info<std_msgs::msg::String>()};
  }
  [[nodiscard]] static Sample sample(const std::string& text) {
    std_msgs::msg::String message;
    message.data(text);
    Sample made;
    made.message = std::make_shared<const std_msgs::msg::String>(message);
    made.sent_wall_ns = 1'500'000'000;
    made.received_wall_ns = 2'000'000'001;
    made.sequence = 4;
    made.source = 9;
    return made;
  }
  const TemporaryFolder folder_;
  Logger log_{"test"};
};

TEST_F(CsvRecordingTest, WritesARowOfTheMessageAndOneOfItsFields) {
  CsvRecording sut("recorder", folder_.path("deep/er"), log_);
  const std::size_t number = sut.add(topic("a/b"));
  sut.write(number, sample("hello"));
  sut.flush();
  EXPECT_THAT(folder_.read("deep/er/messages.csv"),
              HasSubstr("\n2.000000001,1.500000000,a/b,9,4,14\n"));
  EXPECT_EQ(folder_.read("deep/er/a.b.csv"),
            "receive_s,send_s,sequence,data\n2.000000001,1.500000000,4,hello\n");
  EXPECT_EQ(sut.lost(), 0U);
}

TEST_F(CsvRecordingTest, EachTopicHasAFileOnceItHasASample) {
  CsvRecording sut("recorder", folder_.path(), log_);
  const std::size_t first = sut.add(topic("first"));
  const std::size_t second = sut.add(topic("second"));
  sut.write(second, sample("2"));
  sut.flush();
  EXPECT_FALSE(std::filesystem::exists(folder_.path("first.csv")));
  sut.write(first, sample("1"));
  sut.flush();
  EXPECT_THAT(folder_.read("first.csv"), HasSubstr(",1\n"));
  EXPECT_THAT(folder_.read("second.csv"), HasSubstr(",2\n"));
}

TEST_F(CsvRecordingTest, RefusesATopicWhoseFileIsTheOneOfAllMessages) {
  CsvRecording sut("recorder", folder_.path(), log_);
  EXPECT_THROW((void)sut.add(topic("messages")), ConfigError);
}

TEST_F(CsvRecordingTest, CountsWhatAFullDiskTakes) {
  std::filesystem::create_symlink("/dev/full", folder_.path("a.csv"));
  CsvRecording sut("recorder", folder_.path(), log_);
  const std::size_t number = sut.add(topic("a"));
  sut.write(number, sample("1"));
  sut.flush();
  EXPECT_EQ(sut.lost(), 2U);  // the names of the columns, too
}

}  // namespace
}  // namespace tocsin
