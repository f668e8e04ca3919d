// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "encode.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

TEST(Writer, TakesGivenIdsOnce) {
  MemorySink sink;
  Writer sut(sink, {});
  EXPECT_EQ(sut.adopt(Schema{7, "T", "", ""}), 7);
  EXPECT_EQ(sut.adopt(Schema{7, "U", "", ""}), std::nullopt);
  EXPECT_EQ(sut.adopt(Schema{0, "none", "", ""}), std::nullopt);
  EXPECT_EQ(sut.adopt(Channel{0, 7, "/a", "cdr", {}}), 0);  // of a channel it is an id like others
  EXPECT_EQ(sut.adopt(Channel{9, 7, "/a", "cdr", {}}), 9);
  EXPECT_EQ(sut.adopt(Channel{9, 7, "/b", "cdr", {}}), std::nullopt);
}

TEST(Writer, RefusesAChannelOfASchemaThatNobodyDeclared) {
  MemorySink sink;
  Writer sut(sink, {});
  EXPECT_EQ(sut.declare(Channel{0, 1, "/a", "cdr", {}}), std::nullopt);
  EXPECT_EQ(sut.declare(Channel{0, 0, "/a", "json", {}}), 1);
}

TEST(Writer, HasRoomForAllIdsAndNoMore) {
  MemorySink sink;
  Writer sut(sink, {});
  EXPECT_EQ(sut.adopt(Schema{300, "T", "", ""}), 300);
  for (int i = 1; i < 65'535; ++i) ASSERT_TRUE(sut.declare(Schema{})) << i;
  EXPECT_EQ(sut.declare(Schema{}), std::nullopt);
}

TEST(Writer, WritesAChunkWhenItIsFull) {
  MemorySink sink;
  TwoTopics file(sink, small_chunks());
  while (sink.bytes().empty()) (void)file.write({"/a", 0, 1, "12345678"});
  EXPECT_EQ(file.writer.statistics().message_count, 6U);  // of 39 bytes each; 200 is full
  EXPECT_EQ(file.writer.size(), sink.bytes().size());
}

TEST(Writer, TakesNothingAfterItsEnd) {
  MemorySink sink;
  TwoTopics file(sink);
  ASSERT_EQ(file.writer.close(), Kept::all);
  const auto before = sink.bytes();
  EXPECT_EQ(file.write({"/a", 1, 1, "x"}), Kept::nothing);
  EXPECT_EQ(file.writer.write(Metadata{}), Kept::nothing);
  EXPECT_EQ(file.writer.write(Attachment{}), Kept::nothing);
  EXPECT_EQ(file.writer.flush(), Kept::nothing);
  EXPECT_EQ(file.writer.close(), Kept::all);
  EXPECT_EQ(sink.bytes(), before);
}

TEST(Writer, AnEmptyFileIsWhole) {
  Reader reader = reader_of(file_of({}));
  EXPECT_FALSE(reader.damage().no_summary);
  EXPECT_EQ(reader.summary().channels.size(), 2U);
  EXPECT_TRUE(all_of(reader).empty());
}

TEST(Writer, FlushedMessagesCanBeReadWhileItGoesOn) {
  MemorySink sink;
  TwoTopics file(sink);
  const auto messages = numbered(5);
  for (const Sent& sent : messages) (void)file.write(sent);
  EXPECT_TRUE(sink.bytes().empty());
  (void)file.writer.flush();
  Reader reader = reader_of(sink.bytes());
  EXPECT_TRUE(reader.damage().no_summary);
  EXPECT_EQ(reader.damage().cut_at, std::nullopt);
  EXPECT_EQ(all_of(reader), messages);
}

TEST(Writer, KeepsAChunkThatDoesNotGetSmallerAsItIs) {
  std::mt19937 random(5);
  std::string noise(1000, ' ');
  for (char& c : noise) c = static_cast<char>(random());
  Reader reader = reader_of(file_of({{"/a", 0, 1, noise}}, small_chunks(Compression::zstd)));
  EXPECT_EQ(reader.summary().chunks.at(0).compression, "");
  EXPECT_EQ(all_of(reader), (std::vector<Sent>{{"/a", 0, 1, noise}}));
}

/// A chunk of one message as another file has it.
ReadyChunk chunk_of(const Bytes& records, std::uint16_t channel) {
  ReadyChunk chunk;
  chunk.uncompressed_size = records.size();
  chunk.uncompressed_crc = crc32({records.data(), records.size()});
  chunk.compressed = {records.data(), records.size()};
  chunk.entries.push_back({channel, 9, 0});
  return chunk;
}

TEST(Writer, TakesOverAChunkBehindWhatWasWrittenBefore) {
  MemorySink sink;
  TwoTopics file(sink);
  Bytes records;
  put(records, message_of(file.b, {"/b", 2, 9, "foreign"}));
  (void)file.write({"/a", 1, 7, "own"});
  EXPECT_EQ(file.writer.write(chunk_of(records, file.b)), Kept::all);
  (void)file.write({"/a", 3, 11, "own"});
  (void)file.writer.close();
  Reader reader = reader_of(sink.bytes());
  EXPECT_EQ(
      all_of(reader),
      (std::vector<Sent>{{"/a", 1, 7, "own"}, {"/b", 2, 9, "foreign"}, {"/a", 3, 11, "own"}}));
  EXPECT_EQ(reader.summary().chunks.size(), 3U);
  EXPECT_EQ(reader.summary().statistics.channel_message_counts.at(file.b), 1U);
}

TEST(Writer, RefusesAChunkWithAChannelThatNobodyDeclared) {
  MemorySink sink;
  TwoTopics file(sink);
  const Bytes records{1, 2, 3};
  EXPECT_EQ(file.writer.write(chunk_of(records, 77)), Kept::nothing);
  (void)file.writer.close();
  EXPECT_EQ(file.writer.statistics().message_count, 0U);
}

TEST(Writer, CountsByTopicOnlyWhatWasKept) {
  MemorySink sink;
  TwoTopics file(sink, small_chunks());
  for (const Sent& sent : numbered(7)) (void)file.write(sent);
  EXPECT_EQ(file.writer.statistics().message_count, 5U);  // 41 bytes each; two are in memory
  EXPECT_EQ(file.writer.statistics().channel_message_counts.at(file.a), 3U);
  EXPECT_EQ(file.writer.statistics().channel_message_counts.at(file.b), 2U);
  (void)file.writer.flush();
  EXPECT_EQ(file.writer.statistics().message_count, 7U);
  EXPECT_EQ(file.writer.statistics().start_ns, 1000U);
  EXPECT_EQ(file.writer.statistics().end_ns, 1006U);
}

}  // namespace
}  // namespace tocsin::mcap
