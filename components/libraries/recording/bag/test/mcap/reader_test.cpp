// SPDX-License-Identifier: Apache-2.0
#include "mcap/reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

/// Counts what is read.
class CountingSource final : public ByteSource {
 public:
  CountingSource(Bytes bytes, std::uint64_t& count) : inner_(std::move(bytes)), count_(count) {}
  [[nodiscard]] std::uint64_t size() const override { return inner_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::uint8_t* to, std::size_t size) override {
    count_ += size;
    return inner_.read(offset, to, size);
  }

 private:
  MemorySource inner_;
  std::uint64_t& count_;
};

TEST(Reader, OpensByTheSummaryAlone) {
  const Bytes bytes =
      file_of({{"/a", 0, 1, std::string(1'000'000, 'x')}, {"/b", 1, 2, std::string(50, 'y')}});
  std::uint64_t count = 0;
  const Reader sut(std::make_unique<CountingSource>(bytes, count), "test.mcap");
  EXPECT_LT(count, 2000U);
  EXPECT_FALSE(sut.damage().no_summary);
  EXPECT_EQ(sut.summary().statistics.message_count, 2U);
}

TEST(Reader, ASummaryAndAWalkSayTheSame) {
  const Bytes bytes = file_of(numbered(101), small_chunks(Compression::lz4));
  const Reader by_summary = reader_of(bytes);
  const Reader by_walk = reader_of(Bytes(bytes.begin(), bytes.end() - 1));
  ASSERT_FALSE(by_summary.damage().no_summary);
  ASSERT_TRUE(by_walk.damage().no_summary);
  EXPECT_EQ(by_walk.damage().cut_at, std::nullopt);
  const Statistics& a = by_summary.summary().statistics;
  const Statistics& b = by_walk.summary().statistics;
  EXPECT_EQ(std::tie(a.message_count, a.schema_count, a.channel_count, a.chunk_count, a.start_ns,
                     a.end_ns, a.channel_message_counts),
            std::tie(b.message_count, b.schema_count, b.channel_count, b.chunk_count, b.start_ns,
                     b.end_ns, b.channel_message_counts));
}

TEST(Reader, KeepsTheOrderOfTheFileAmongEqualTimes) {
  std::vector<Sent> messages;
  for (std::uint32_t i = 0; i < 50; ++i) messages.push_back({"/a", i, 77, "same"});
  Reader sut = reader_of(file_of(messages, small_chunks()));
  EXPECT_EQ(all_of(sut), messages);
}

TEST(Reader, GivesOnlyTheTimesThatAreWantedBothEndsIncluded) {
  Reader sut = reader_of(file_of(numbered(100), small_chunks()));
  Query query;
  query.from_ns = 1010;
  query.to_ns = 1020;
  const auto messages = all_of(sut, query);
  ASSERT_EQ(messages.size(), 11U);
  EXPECT_EQ(messages.front().log_time_ns, 1010U);
  EXPECT_EQ(messages.back().log_time_ns, 1020U);
}

TEST(Reader, GivesOnlyTheTopicsThatAreWantedAndReadsNoOtherChunk) {
  std::vector<Sent> messages(10, {"/a", 1, 5, std::string(300, 'a')});
  messages.push_back({"/b", 2, 6, "b"});
  std::uint64_t count = 0;
  Reader sut(std::make_unique<CountingSource>(file_of(messages, small_chunks()), count), "test");
  count = 0;
  Query query;
  query.wanted = [](const Channel& channel) { return channel.topic == "/b"; };
  EXPECT_EQ(all_of(sut, query), (std::vector<Sent>{{"/b", 2, 6, "b"}}));
  EXPECT_LT(count, 300U);
}

TEST(Reader, CountsADamagedChunkAndGivesTheOthers) {
  const auto messages = numbered(100);
  Bytes bytes = file_of(messages, small_chunks());
  const ChunkIndex second = reader_of(bytes).summary().chunks.at(1);
  bytes[second.offset + second.length - 1] ^= 1U;
  Reader sut = reader_of(bytes);
  const auto rest = all_of(sut);
  EXPECT_EQ(sut.damage().chunks, 1U);
  EXPECT_LT(rest.size(), 98U);
  EXPECT_GT(rest.size(), 90U);
  EXPECT_EQ(rest.front(), messages.front());
  EXPECT_EQ(rest.back(), messages.back());
}

TEST(Reader, WalksOverAFileWhoseSummaryIsDamaged) {
  Bytes bytes = file_of(numbered(100), small_chunks());
  bytes[bytes.size() - 60] ^= 1U;
  Reader sut = reader_of(bytes);
  EXPECT_TRUE(sut.damage().no_summary);
  EXPECT_EQ(all_of(sut), numbered(100));
}

TEST(Reader, StopsAtZerosThatAPowerCutLeft) {
  const auto messages = numbered(20);
  MemorySink sink;
  TwoTopics file(sink, small_chunks());
  for (const Sent& sent : messages) (void)file.write(sent);
  (void)file.writer.flush();
  Bytes bytes = sink.bytes();
  const std::uint64_t end = bytes.size();
  bytes.resize(end + 4096);
  Reader sut = reader_of(bytes);
  EXPECT_EQ(sut.damage().cut_at, end);
  EXPECT_EQ(all_of(sut), messages);
}

TEST(Reader, GivesAttachmentsAndMetadata) {
  MemorySink sink;
  TwoTopics file(sink);
  ASSERT_EQ(file.writer.write(Attachment{5, 6, "map.pgm", "image/x-pgm", "P5"}), Kept::all);
  ASSERT_EQ(file.writer.write(Metadata{"run", {{"seed", "3"}}}), Kept::all);
  (void)file.writer.close();
  for (const bool closed : {true, false}) {
    Bytes bytes = sink.bytes();
    if (!closed) bytes.pop_back();
    Reader sut = reader_of(bytes);
    ASSERT_EQ(sut.summary().attachments.size(), 1U);
    const auto attachment = sut.read(sut.summary().attachments[0]);
    ASSERT_TRUE(attachment);
    EXPECT_EQ(attachment->data, "P5");
    EXPECT_EQ(attachment->media_type, "image/x-pgm");
    EXPECT_EQ(attachment->create_time_ns, 6U);
    ASSERT_EQ(sut.summary().metadata.size(), 1U);
    EXPECT_EQ(sut.read(sut.summary().metadata[0])->values, (KeyValues{{"seed", "3"}}));
  }
}

TEST(Reader, RefusesAnAttachmentWhoseChecksumIsWrong) {
  MemorySink sink;
  TwoTopics file(sink);
  (void)file.writer.write(Attachment{5, 6, "map.pgm", "image/x-pgm", "PPPPPP"});
  (void)file.writer.close();
  Bytes bytes = sink.bytes();
  const std::string wanted = "PPPPPP";
  *std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end()) = 'Q';
  Reader sut = reader_of(bytes);
  EXPECT_FALSE(sut.read(sut.summary().attachments.at(0)));
}

TEST(Reader, RefusesWhatIsNoMcapFileByItsName) {
  const TemporaryFolder folder;
  for (const std::string text : {"abc", "a text that is longer than the magic bytes"}) {
    const std::string path = folder.write("wrong.mcap", text);
    try {
      const Reader sut(path);
      FAIL() << text;
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find("wrong.mcap"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace tocsin::mcap
