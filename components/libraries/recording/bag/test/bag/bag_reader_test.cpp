// SPDX-License-Identifier: Apache-2.0
#include "bag/bag_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "bags.hpp"
#include "foundation/error.hpp"
#include "mcap/writer.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(BagReader, TellsWhatIsInABag) {
  const TemporaryFolder folder;
  write_bag(folder.path("run"), 5);
  BagReader sut(folder.path("run"));
  ASSERT_EQ(sut.topics().size(), 1U);
  const Topic& topic = sut.topics()[0].topic;
  EXPECT_EQ(topic.name, "/chatter");
  EXPECT_EQ(topic.type, "std_msgs/msg/String");
  EXPECT_EQ(topic.definition, "string data\n");
  EXPECT_EQ(topic.offered_qos.size(), 1U);
  EXPECT_EQ(sut.topics()[0].count, 5U);
  EXPECT_EQ(sut.about().start_ns, t0);
  EXPECT_EQ(sut.about().duration_ns, 4 * second);
  EXPECT_EQ(sut.size(), fs::file_size(folder.path("run/run_0.mcap")));
  EXPECT_TRUE(sut.damaged().empty());
  EXPECT_EQ(all_of(sut).at(3), Got("/chatter", 3, t0 + 3 * second, "text 3"));
}

TEST(BagReader, ReadsOneFileAlone) {
  const TemporaryFolder folder;
  write_bag(folder.path("run"), 5);
  BagReader sut(folder.path("run/run_0.mcap"));
  EXPECT_EQ(all_of(sut).size(), 5U);
}

TEST(BagReader, ReadsAFolderWithoutMetadata) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_duration_s = 2;
  write_bag(folder.path("run"), 5, options);
  fs::remove(folder.path("run/metadata.yaml"));
  BagReader sut(folder.path("run"));
  EXPECT_EQ(sut.about().files.size(), 3U);
  EXPECT_EQ(all_of(sut).size(), 5U);
}

TEST(BagReader, BringsTheFilesInOrderOfTime) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("run"));
  // Two files whose times overlap; the later one by name begins first.
  for (const int number : {0, 1}) {
    mcap::FileSink sink(folder.path("run/run_" + std::to_string(number) + ".mcap"));
    mcap::Writer writer(sink, {});
    const auto channel = *writer.declare(mcap::Channel{0, 0, "/a", "cdr", {}});
    for (std::uint64_t i = 0; i < 10; ++i) {
      const std::uint64_t time = 1000 + 2 * i - static_cast<std::uint64_t>(number);
      (void)writer.write(mcap::Message{channel, 0, time, time, nullptr, 0});
    }
  }
  BagReader sut(folder.path("run"));
  ASSERT_EQ(sut.topics().size(), 1U);
  EXPECT_EQ(sut.topics()[0].count, 20U);
  std::int64_t expected = 999;
  for (const auto& got : all_of(sut)) EXPECT_EQ(std::get<2>(got), expected++);
  EXPECT_EQ(expected, 1019);
}

TEST(BagReader, GivesOnlyTheTimesAndTopicsThatAreWanted) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_duration_s = 2;
  write_bag(folder.path("run"), 10, options);
  BagReader sut(folder.path("run"));
  Selection selection;
  selection.from_ns = t0 + 3 * second;
  selection.to_ns = t0 + 5 * second;
  EXPECT_EQ(all_of(sut, selection).size(), 3U);
  selection.wanted = [](const Topic& topic) { return topic.name == "/other"; };
  EXPECT_TRUE(all_of(sut, selection).empty());
}

TEST(BagReader, GivesThePartOfAFileThatWasCut) {
  const TemporaryFolder folder;
  write_bag(folder.path("run"), 5);
  const std::string path = folder.path("run/run_0.mcap");
  fs::resize_file(path, fs::file_size(path) - 20);
  BagReader sut(folder.path("run"));
  EXPECT_EQ(all_of(sut).size(), 5U);
  ASSERT_EQ(sut.damaged().size(), 1U);
  EXPECT_EQ(sut.damaged()[0].first, "run_0.mcap");
}

TEST(BagReader, TakesTimesThatNoClockShows) {
  const TemporaryFolder folder;
  const std::string path = folder.path("wild.mcap");
  {
    mcap::FileSink sink(path);
    mcap::Writer writer(sink, {});
    const auto channel = *writer.declare(mcap::Channel{0, 0, "/a", "", {}});
    for (const std::uint64_t time : {std::uint64_t{0}, ~std::uint64_t{0}}) {
      (void)writer.write(mcap::Message{channel, 0, time, time, nullptr, 0});
    }
  }
  BagReader sut(path);
  EXPECT_GT(sut.about().duration_ns, 0);
  const auto got = all_of(sut);
  ASSERT_EQ(got.size(), 1U);  // the other one is beyond all times that can be asked for
  EXPECT_EQ(std::get<2>(got[0]), 0);
}

std::string error_of(const std::string& path) {
  try {
    const BagReader sut(path);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(BagReader, RefusesWhatIsNoBag) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of(folder.path("absent")), HasSubstr("absent: cannot be read"));
  EXPECT_THAT(error_of(folder.path()), HasSubstr("is no bag"));
  EXPECT_THAT(error_of(folder.write("text.mcap", "a text of some length")),
              HasSubstr("text.mcap: is no MCAP file"));
}

TEST(BagReader, NamesAFileOfMetadataThatIsMissing) {
  const TemporaryFolder folder;
  write_bag(folder.path("run"), 1);
  fs::remove(folder.path("run/run_0.mcap"));
  EXPECT_THAT(error_of(folder.path("run")), HasSubstr("run/run_0.mcap: cannot be read"));
}

}  // namespace
}  // namespace tocsin::bag
