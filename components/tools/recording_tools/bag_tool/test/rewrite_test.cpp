// SPDX-License-Identifier: Apache-2.0
#include "rewrite.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "bag/bag_reader.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "tool_bags.hpp"

namespace tocsin::bag_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> topics_of(const bag::BagReader& reader) {
  std::vector<std::string> names;
  for (const auto& one : reader.topics()) names.push_back(one.topic.name);
  return names;
}

class Rewrite : public ::testing::Test {
 protected:
  Rewrite() {
    order.inputs = {folder.path("run")};
    order.output = folder.path("out");
    write_bag(folder.path("run"), {"/a", "/b"}, 10);
  }
  const TemporaryFolder folder;
  RewriteOrder order;
};

TEST_F(Rewrite, CopiesAll) {
  EXPECT_EQ(rewrite(order).messages, 20U);
  const bag::BagReader reader(folder.path("out"));
  EXPECT_THAT(topics_of(reader), ElementsAre("/a", "/b"));
  EXPECT_EQ(reader.about().count, 20U);
  EXPECT_EQ(reader.topics()[0].topic.definition, "string data\n");
}

TEST_F(Rewrite, CopiesOnlyTheTopicsThatAreWanted) {
  order.topics.topics = {"b"};
  EXPECT_EQ(rewrite(order).messages, 10U);
  EXPECT_THAT(topics_of(bag::BagReader(folder.path("out"))), ElementsAre("/b"));
}

TEST_F(Rewrite, CopiesOnlyThePartOfTheTimeThatIsWanted) {
  order.start_offset_s = 3;
  order.duration_s = 2;
  EXPECT_EQ(rewrite(order).messages, 6U);
  const bag::BagReader reader(folder.path("out"));
  EXPECT_EQ(reader.about().start_ns, t0 + 3 * second);
  EXPECT_EQ(reader.about().duration_ns, 2 * second);
}

TEST_F(Rewrite, MergesInOrderOfTimeAndTopicsOfOneNameAreOne) {
  write_bag(folder.path("other"), {"/b", "/c"}, 10, t0 + second / 2);
  order.inputs.push_back(folder.path("other"));
  EXPECT_EQ(rewrite(order).messages, 40U);
  bag::BagReader reader(folder.path("out"));
  EXPECT_THAT(topics_of(reader), ElementsAre("/a", "/b", "/c"));
  EXPECT_EQ(reader.topics()[1].count, 20U);
  const auto stream = reader.messages();
  std::int64_t last = 0;
  while (const auto one = stream->next()) {
    EXPECT_GE(one->message.log_time_ns, last);
    last = one->message.log_time_ns;
  }
}

TEST_F(Rewrite, PacksAndSplits) {
  order.options.compression = mcap::Compression::zstd;
  order.options.max_duration_s = 5;
  EXPECT_EQ(rewrite(order).messages, 20U);
  const bag::BagReader reader(folder.path("out"));
  EXPECT_EQ(reader.about().files.size(), 2U);
  const mcap::Reader file(folder.path("out/out_0.mcap"));
  EXPECT_EQ(file.summary().chunks.at(0).compression, "zstd");
}

TEST_F(Rewrite, TellsWhatItsInputsLack) {
  const std::string path = folder.path("run/run_0.mcap");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 20);
  const Rewritten result = rewrite(order);
  EXPECT_EQ(result.messages, 20U);
  EXPECT_THAT(result.damage, ElementsAre(HasSubstr("run_0.mcap has no summary")));
}

TEST_F(Rewrite, TakesAttachmentsAndMetadataAlong) {
  {
    bag::BagWriter writer(folder.path("more"), {});
    (void)writer.write(mcap::Attachment{1, 2, "map.pgm", "", "P5"});
    (void)writer.write(mcap::Metadata{"run", {{"seed", "3"}}});
  }
  order.inputs = {folder.path("more"), folder.path("run")};
  (void)rewrite(order);
  bag::BagReader reader(folder.path("out"));
  EXPECT_EQ(reader.attachments().at(0).name, "map.pgm");
  EXPECT_EQ(reader.metadata().at(0).values.at("seed"), "3");
}

TEST_F(Rewrite, RefusesAnOutputThatIsThereAndAnInputThatIsNot) {
  order.output = folder.path("run");
  EXPECT_THROW((void)rewrite(order), ConfigError);
  order.output = folder.path("out");
  order.inputs = {folder.path("absent")};
  EXPECT_THROW((void)rewrite(order), ConfigError);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

}  // namespace
}  // namespace tocsin::bag_tool
