// SPDX-License-Identifier: Apache-2.0
#include "export.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "tool_bags.hpp"

namespace tocsin::bag_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ExportTest : public ::testing::Test {
 protected:
  ExportTest() {
    write_bag(folder_.path("run"), {"/a/b", "/c"}, 4);
    order_.inputs = {folder_.path("run")};
    order_.output = folder_.path("csv");
  }
  const TemporaryFolder folder_;
  RewriteOrder order_;
};

TEST_F(ExportTest, HasARowForEachMessage) {
  const Exported sut = export_csv(order_);
  EXPECT_EQ(sut.messages, 8U);
  EXPECT_EQ(sut.lost, 0U);
  EXPECT_THAT(folder_.read("csv/messages.csv"),
              HasSubstr("\n1700000003.000000000,1700000003.000000000,c,0,3,14\n"));
  EXPECT_THAT(folder_.read("csv/a.b.csv"),
              EndsWith("\n1700000003.000000000,1700000003.000000000,3,hello\n"));
}

TEST_F(ExportTest, TakesThePartThatIsWanted) {
  order_.topics.topics = {"/c"};
  order_.start_offset_s = 1;
  order_.duration_s = 1;
  EXPECT_EQ(export_csv(order_).messages, 2U);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("csv/a.b.csv")));
  EXPECT_THAT(folder_.read("csv/c.csv"), Not(HasSubstr(",0,hello")));
}

TEST_F(ExportTest, NamesTopicsWhoseTypeNobodyHas) {
  EXPECT_THAT(export_csv(order_).unknown, IsEmpty());
  {
    bag::BagWriter writer(folder_.path("other"), {});
    bag::Topic topic;
    topic.name = "/scan";
    topic.type = "foreign_msgs/msg/Scan";
    (void)writer.write(writer.add(topic), {1, t0, t0, nullptr, 0});
  }
  order_.inputs = {folder_.path("other")};
  order_.output = folder_.path("csv_2");
  EXPECT_THAT(export_csv(order_).unknown, ElementsAre("scan"));
}

TEST_F(ExportTest, RefusesAFolderThatIsThereAndWhatIsNoBag) {
  (void)folder_.write("csv/precious", "x");
  EXPECT_THROW((void)export_csv(order_), ConfigError);
  EXPECT_EQ(folder_.read("csv/precious"), "x");
  order_.inputs = {folder_.path("none")};
  order_.output = folder_.path("csv_2");
  EXPECT_THROW((void)export_csv(order_), ConfigError);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("csv_2")));
}

}  // namespace
}  // namespace tocsin::bag_tool
