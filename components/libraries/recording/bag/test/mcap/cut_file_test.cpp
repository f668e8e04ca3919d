// SPDX-License-Identifier: Apache-2.0
// A file cut anywhere (a killed recorder, a full disk, a power cut) gives all that came before.
#include <gtest/gtest.h>

#include <algorithm>

#include "mcap/recovery.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

constexpr std::size_t magic_bytes = 8;

class CutFile : public ::testing::TestWithParam<Compression> {};
INSTANTIATE_TEST_SUITE_P(Each, CutFile,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

/// Those of `messages` that stand in the file before `end`: whole chunks, and when nothing is
/// packed also whole messages of the chunk that was cut.
std::size_t complete(const Reader& whole, std::uint64_t end) {
  std::size_t count = 0;
  for (const ChunkIndex& chunk : whole.summary().chunks) {
    if (chunk.offset + chunk.length > end) break;
    count += (chunk.message_index_length - chunk.message_indexes.size() * 15) / 16;
  }
  return count;
}

TEST_P(CutFile, GivesAllThatCameBeforeTheCutAtEveryByte) {
  const auto messages = numbered(40);
  const Bytes bytes = file_of(messages, small_chunks(GetParam()));
  const Reader whole = reader_of(bytes);
  std::size_t before = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto got = messages_in(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size)));
    ASSERT_LE(got.size(), messages.size());
    ASSERT_TRUE(std::equal(got.begin(), got.end(), messages.begin())) << size;
    ASSERT_GE(got.size(), complete(whole, size)) << size;
    ASSERT_GE(got.size(), before) << "fewer than of a shorter file at " << size;
    before = got.size();
  }
  EXPECT_EQ(before, messages.size());
}

TEST_P(CutFile, IsMendedToAWholeFileWithTheSameMessagesAtEveryByte) {
  const Bytes bytes = file_of(numbered(20), small_chunks(GetParam()));
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<long>(size));
    MemorySource source(cut);
    MemorySink sink;
    Writer writer(sink, small_chunks(GetParam()));
    const Recovered recovered = recover(source, writer);
    ASSERT_EQ(writer.close(), Kept::all);
    Reader mended = reader_of(sink.bytes());
    ASSERT_FALSE(mended.damage().no_summary) << size;
    ASSERT_EQ(all_of(mended), messages_in(cut)) << size;
    ASSERT_EQ(mended.summary().statistics.message_count, recovered.messages) << size;
  }
}

TEST(CutFile, GivesTheWholeMessagesOfAnUnpackedChunkThatWasCut) {
  const auto messages = numbered(10);
  WriterOptions options;  // one chunk
  const Bytes bytes = file_of(messages, options);
  const ChunkIndex chunk = reader_of(bytes).summary().chunks.at(0);
  const auto cut = static_cast<long>(chunk.offset + chunk.length - 1);  // in the last message
  const auto got = messages_in(Bytes(bytes.begin(), bytes.begin() + cut));
  EXPECT_EQ(got, std::vector<Sent>(messages.begin(), messages.end() - 1));
}

TEST(CutFile, TellsWhereItWasCut) {
  const Bytes bytes = file_of(numbered(40), small_chunks());
  const ChunkIndex third = reader_of(bytes).summary().chunks.at(2);
  const auto cut = static_cast<long>(third.offset + third.length - 3);
  const Reader sut = reader_of(Bytes(bytes.begin(), bytes.begin() + cut));
  EXPECT_TRUE(sut.damage().no_summary);
  EXPECT_EQ(sut.damage().cut_at, third.offset);
}

TEST(CutFile, GivesAttachmentsAndMetadataThatCameBeforeTheCut) {
  MemorySink sink;
  {
    TwoTopics file(sink);
    (void)file.writer.write(Attachment{1, 2, "first", "", "1"});
    (void)file.writer.write(Metadata{"second", {}});
    (void)file.writer.write(Attachment{3, 4, "third", "", "3"});
  }
  const Reader whole = reader_of(sink.bytes());
  const auto cut = static_cast<long>(whole.summary().attachments.at(1).offset + 12);
  const Reader sut = reader_of(Bytes(sink.bytes().begin(), sink.bytes().begin() + cut));
  ASSERT_EQ(sut.summary().attachments.size(), 1U);
  EXPECT_EQ(sut.summary().attachments[0].name, "first");
  ASSERT_EQ(sut.summary().metadata.size(), 1U);
  EXPECT_EQ(sut.summary().metadata[0].name, "second");
  EXPECT_EQ(sut.damage().cut_at, whole.summary().attachments[1].offset);
}

TEST(CutFile, ShorterThanItsMagicHoldsNothing) {
  const Bytes bytes = file_of(numbered(3));
  for (std::size_t size = 0; size < magic_bytes; ++size) {
    Reader sut = reader_of(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size)));
    EXPECT_EQ(sut.damage().cut_at, 0U);
    EXPECT_TRUE(sut.damage().no_summary);
    EXPECT_TRUE(all_of(sut).empty());
  }
}

}  // namespace
}  // namespace tocsin::mcap
