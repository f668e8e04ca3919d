// SPDX-License-Identifier: Apache-2.0
#include "bag/bag_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "bags.hpp"
#include "foundation/error.hpp"
#include "foundation/small_disk.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(BagWriter, MakesAFolderWithItsFileAndMetadata) {
  const TemporaryFolder folder;
  write_bag(folder.path("run/"), 5);
  EXPECT_TRUE(fs::exists(folder.path("run/run_0.mcap")));
  const std::string metadata = folder.read("run/metadata.yaml");
  EXPECT_THAT(metadata, HasSubstr("message_count: 5"));
  EXPECT_THAT(metadata, HasSubstr("nanoseconds: 4000000000"));
  EXPECT_THAT(metadata, HasSubstr("nanoseconds_since_epoch: 1700000000000000000"));
}

TEST(BagWriter, TellsEachMessagesWriterAndATopicStaysOne) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_duration_s = 2;
  {
    BagWriter sut(folder.path("run"), options);
    const std::size_t topic = sut.add(text_topic("/chatter"));
    const std::string text = "x";
    std::uint32_t sequence = 0;
    for (const std::uint64_t writer : {7U, 8U, 0U, 7U}) {
      ++sequence;
      Message message = message_of(sequence, t0 + sequence * second, text);
      message.writer = writer;
      (void)sut.write(topic, message);
    }
  }
  BagReader reader(folder.path("run"));
  ASSERT_EQ(reader.about().files.size(), 2U);
  ASSERT_EQ(reader.topics().size(), 1U);
  EXPECT_EQ(reader.topics()[0].count, 4U);
  std::vector<std::uint64_t> writers;
  const auto stream = reader.messages();
  while (const auto one = stream->next()) writers.push_back(one->message.writer);
  EXPECT_THAT(writers, ::testing::ElementsAre(7, 8, 0, 7));
  EXPECT_THAT(folder.read("run/metadata.yaml"), HasSubstr("message_count: 4"));
}

TEST(BagWriter, RefusesAFolderThatIsThere) {
  const TemporaryFolder folder;
  folder.write("run/precious", "x");
  try {
    const BagWriter sut(folder.path("run"), {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("run: is there already"));
  }
  EXPECT_EQ(folder.read("run/precious"), "x");
  EXPECT_THROW(BagWriter("/proc/none/run", {}), ConfigError);
}

TEST(BagWriter, SplitsByDuration) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_duration_s = 2;
  write_bag(folder.path("run"), 5, options);  // 0 1 | 2 3 | 4
  const BagReader reader(folder.path("run"));
  ASSERT_EQ(reader.about().files.size(), 3U);
  EXPECT_EQ(reader.about().files[0].count, 2U);
  EXPECT_EQ(reader.about().files[1].count, 2U);
  EXPECT_EQ(reader.about().files[2].path, "run_2.mcap");
  EXPECT_EQ(reader.about().count, 5U);
  EXPECT_EQ(reader.about().duration_ns, 4 * second);
}

TEST(BagWriter, SplitsBySize) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_bytes = 100'000;
  {
    BagWriter sut(folder.path("run"), options);
    const std::size_t topic = sut.add(text_topic("/a"));
    const std::string large(30'000, 'x');
    for (std::uint32_t i = 0; i < 9; ++i) (void)sut.write(topic, message_of(i, t0 + i, large));
  }
  BagReader reader(folder.path("run"));
  EXPECT_EQ(reader.about().files.size(), 3U);  // four pass the limit, but the last are one
  for (const auto& file : reader.about().files) {
    EXPECT_LT(fs::file_size(folder.path("run/" + file.path)), 100'000U + 32'000U);
  }
  EXPECT_EQ(all_of(reader).size(), 9U);
}

TEST(BagWriter, TellsTopicsThatCameLateInEveryFileFromThenOn) {
  const TemporaryFolder folder;
  BagOptions options;
  options.max_duration_s = 1;
  {
    BagWriter sut(folder.path("run"), options);
    const std::size_t a = sut.add(text_topic("/a"));
    (void)sut.write(a, message_of(1, t0, "x"));
    const std::size_t b = sut.add(text_topic("/b"));
    (void)sut.write(b, message_of(1, t0 + 1, "y"));
    (void)sut.write(b, message_of(2, t0 + 2 * second, "z"));
  }
  BagReader reader(folder.path("run"));
  ASSERT_EQ(reader.topics().size(), 2U);
  EXPECT_EQ(reader.topics()[1].count, 2U);
  EXPECT_EQ(all_of(reader).back(), Got("/b", 2, t0 + 2 * second, "z"));
  EXPECT_THAT(folder.read("run/metadata.yaml"), HasSubstr("message_count: 3"));
}

TEST(BagWriter, CanBeReadWhileItIsWritten) {
  const TemporaryFolder folder;
  BagWriter sut(folder.path("run"), {});
  const std::size_t topic = sut.add(text_topic("/a"));
  (void)sut.write(topic, message_of(1, t0, "x"));
  ASSERT_EQ(sut.flush(), mcap::Kept::all);
  BagReader reader(folder.path("run"));
  EXPECT_EQ(all_of(reader).size(), 1U);
  EXPECT_TRUE(reader.damaged().at(0).second.no_summary);
}

TEST(BagWriter, KeepsAttachmentsAndMetadata) {
  const TemporaryFolder folder;
  {
    BagWriter sut(folder.path("run"), {});
    EXPECT_EQ(sut.write(mcap::Attachment{1, 2, "map.pgm", "", "P5"}), mcap::Kept::all);
    EXPECT_EQ(sut.write(mcap::Metadata{"run", {{"seed", "3"}}}), mcap::Kept::all);
  }
  BagReader reader(folder.path("run"));
  EXPECT_EQ(reader.attachments().at(0).data, "P5");
  EXPECT_EQ(reader.metadata().at(0).values.at("seed"), "3");
}

TEST(BagWriter, CountsWhatAFullDiskTakesAndGoesOn) {
  const TemporaryFolder folder;
  BagWriter sut(folder.path("run"), {});
  const std::size_t topic = sut.add(text_topic("/a"));
  (void)sut.write(topic, message_of(1, t0, "kept"));
  (void)sut.flush();
  {
    const SmallDisk disk(fs::file_size(folder.path("run/run_0.mcap")));
    (void)sut.write(topic, message_of(2, t0 + 1, "lost"));
    EXPECT_EQ(sut.flush(), mcap::Kept::nothing);
  }
  (void)sut.write(topic, message_of(3, t0 + 2, "kept"));
  EXPECT_EQ(sut.close(), mcap::Kept::all);
  EXPECT_EQ(sut.lost(), 1U);
  BagReader reader(folder.path("run"));
  EXPECT_EQ(all_of(reader).size(), 2U);
  EXPECT_THAT(folder.read("run/metadata.yaml"), HasSubstr("message_count: 2"));
}

TEST(BagWriter, BeginsOnAFullDiskAndWritesItsMetadataWhenThereIsRoom) {
  const TemporaryFolder folder;
  std::optional<BagWriter> sut;
  {
    const SmallDisk disk(0);
    sut.emplace(folder.path("run"), BagOptions{});
    EXPECT_FALSE(fs::exists(folder.path("run/metadata.yaml")));
  }
  EXPECT_EQ(sut->flush(), mcap::Kept::all);
  EXPECT_TRUE(fs::exists(folder.path("run/metadata.yaml")));
  EXPECT_EQ(BagReader(folder.path("run")).about().files.size(), 1U);
}

}  // namespace
}  // namespace tocsin::bag
