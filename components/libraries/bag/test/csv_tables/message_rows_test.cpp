// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/message_rows.hpp"

#include <gmock/gmock.h>

#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;

const RecordedMessage message{"a/b", 2'000'000'001, 1'500'000'000, 9, 4, 14};

TEST(MessageRow, TellsTimesWriterNumberAndSize) {
  const NamedRow sut = message_row(message);
  EXPECT_THAT(sut.columns,
              ElementsAre("receive_s", "send_s", "topic", "writer", "sequence", "bytes"));
  EXPECT_THAT(sut.cells, ElementsAre("2.000000001", "1.500000000", "a/b", "9", "4", "14"));
}

TEST(FieldRow, HasTheFieldsBehindTheTimes) {
  std_msgs::msg::String text;
  text.data("hello");
  const NamedRow sut = field_row(message, type_info<std_msgs::msg::String>(), &text);
  EXPECT_THAT(sut.columns, ElementsAre("receive_s", "send_s", "sequence", "data"));
  EXPECT_THAT(sut.cells, ElementsAre("2.000000001", "1.500000000", "4", "hello"));
}

TEST(TableFile, IsTheTopicsNameWithPointsForSlashes) {
  EXPECT_EQ(table_file("camera/image_raw/compressed"), "camera.image_raw.compressed.csv");
  EXPECT_EQ(table_file("odom"), "odom.csv");
}

TEST(CsvLine, QuotesWhatWouldBeTwoCells) { EXPECT_EQ(csv_line({"a", "b,c", ""}), "a,\"b,c\",\n"); }

}  // namespace
}  // namespace tocsin
