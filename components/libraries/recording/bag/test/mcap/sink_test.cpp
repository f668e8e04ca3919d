// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/small_disk.hpp"
#include "foundation/temporary_folder.hpp"
#include "mcap/byte_sink.hpp"
#include "mcap/byte_source.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

Span span_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

TEST(FileSink, RefusesAFileThatIsThere) {
  const TemporaryFolder folder;
  folder.write("a.mcap", "precious");
  EXPECT_THROW(FileSink(folder.path("a.mcap")), ConfigError);
  EXPECT_EQ(folder.read("a.mcap"), "precious");
}

TEST(FileSink, AFullDiskLeavesNoHalfRecord) {
  const TemporaryFolder folder;
  FileSink sut(folder.path("a.mcap"));
  ASSERT_EQ(sut.append({span_of("kept ")}), Kept::all);
  {
    const SmallDisk disk(8);
    EXPECT_EQ(sut.append({span_of("12"), span_of("does not fit")}), Kept::nothing);
  }
  EXPECT_EQ(folder.read("a.mcap"), "kept ");
  EXPECT_EQ(sut.append({span_of("again")}), Kept::all);
  EXPECT_EQ(folder.read("a.mcap"), "kept again");
}

TEST(WriterOnAFullDisk, LosesWholeChunksCountsThemAndGoesOn) {
  const TemporaryFolder folder;
  const auto messages = numbered(30);
  FileSink sink(folder.path("a.mcap"));
  TwoTopics file(sink, small_chunks());
  for (int i = 0; i < 10; ++i) (void)file.write(messages[i]);
  ASSERT_EQ(file.writer.flush(), Kept::all);
  {
    const SmallDisk disk(std::filesystem::file_size(folder.path("a.mcap")) + 100);
    for (int i = 10; i < 20; ++i) (void)file.write(messages[i]);
    (void)file.writer.flush();
  }
  EXPECT_EQ(file.writer.lost(), 10U);
  for (int i = 20; i < 30; ++i) (void)file.write(messages[i]);
  EXPECT_EQ(file.writer.close(), Kept::all);
  EXPECT_EQ(file.writer.statistics().message_count, 20U);

  Reader reader(folder.path("a.mcap"));
  EXPECT_FALSE(reader.damage().no_summary);
  auto kept = std::vector<Sent>(messages.begin(), messages.begin() + 10);
  kept.insert(kept.end(), messages.begin() + 20, messages.end());
  EXPECT_EQ(all_of(reader), kept);
}

TEST(WriterOnAFullDisk, TellsSchemasAndChannelsWhenThereIsRoomAgain) {
  const TemporaryFolder folder;
  FileSink sink(folder.path("a.mcap"));
  const auto messages = numbered(20);
  auto file = std::make_unique<TwoTopics>(sink, small_chunks());
  {
    const SmallDisk disk(20);
    for (int i = 0; i < 10; ++i) (void)file->write(messages[i]);
    (void)file->writer.flush();
    EXPECT_EQ(file->writer.lost(), 10U);
  }
  for (int i = 10; i < 20; ++i) (void)file->write(messages[i]);
  file.reset();
  Reader reader(folder.path("a.mcap"));
  EXPECT_EQ(all_of(reader), std::vector<Sent>(messages.begin() + 10, messages.end()));
}

TEST(FileSource, ReadsSmallAndLargePartsAndNothingBeyondTheEnd) {
  const TemporaryFolder folder;
  std::string text(300'000, '?');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i % 23);
  FileSource sut(folder.write("a", text));
  EXPECT_EQ(sut.size(), text.size());
  for (const auto& [offset, size] : std::vector<std::pair<std::size_t, std::size_t>>{
           {0, 5}, {65'530, 20}, {3, 5}, {100'000, 150'000}, {299'990, 10}, {300'000, 0}}) {
    std::string part(size, '!');
    ASSERT_TRUE(sut.read(offset, reinterpret_cast<std::uint8_t*>(part.data()), size)) << offset;
    EXPECT_EQ(part, text.substr(offset, size)) << offset;
  }
  std::uint8_t byte = 0;
  EXPECT_FALSE(sut.read(300'000, &byte, 1));
  EXPECT_FALSE(sut.read(~std::uint64_t{0}, &byte, 1));
}

TEST(FileSource, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileSource(folder.path("absent")), ConfigError);
  EXPECT_THROW(FileSource(folder.path()), ConfigError);
}

}  // namespace
}  // namespace tocsin::mcap
