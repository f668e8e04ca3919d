// SPDX-License-Identifier: Apache-2.0
// What a stream loads, and what it makes of an index that lies.
#include "message_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

/// Tells where it was read.
class WatchedSource final : public ByteSource {
 public:
  explicit WatchedSource(Bytes bytes) : inner_(std::move(bytes)) {}
  std::vector<std::uint64_t> offsets;

  [[nodiscard]] std::uint64_t size() const override { return inner_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::uint8_t* to, std::size_t size) override {
    offsets.push_back(offset);
    return inner_.read(offset, to, size);
  }

 private:
  MemorySource inner_;
};

struct Streamed {
  explicit Streamed(const std::vector<Sent>& messages)
      : bytes(file_of(messages, small_chunks())),
        source(bytes),
        summary(reader_of(bytes).summary()) {}

  std::vector<std::uint64_t> times(const Query& query = {}) {
    const auto stream = make_message_stream(source, summary, query, damage);
    std::vector<std::uint64_t> result;
    while (const auto message = stream->next()) result.push_back(message->log_time_ns);
    return result;
  }

  Bytes bytes;
  WatchedSource source;
  Summary summary;
  Damage damage;
};

TEST(MessageStream, LoadsAChunkOnlyWhenItsTimeHasCome) {
  Streamed sut(numbered(100));
  ASSERT_GT(sut.summary.chunks.size(), 10U);
  const auto stream = make_message_stream(sut.source, sut.summary, {}, sut.damage);
  (void)stream->next();
  EXPECT_EQ(sut.source.offsets.size(), 1U);
}

TEST(MessageStream, LoadsEachChunkOnce) {
  Streamed sut(numbered(100));
  (void)sut.times();
  EXPECT_EQ(sut.source.offsets.size(), sut.summary.chunks.size());
}

TEST(MessageStream, SkipsChunksOutsideOfTheTimesWanted) {
  Streamed sut(numbered(100));
  Query query;
  query.from_ns = 1098;
  EXPECT_EQ(sut.times(query), (std::vector<std::uint64_t>{1098, 1099}));
  EXPECT_EQ(sut.source.offsets.size(), 1U);
  query.from_ns = 5000;
  EXPECT_TRUE(sut.times(query).empty());
}

TEST(MessageStream, GivesEveryMessageOnceThoughTheIndexLiesAboutTimes) {
  Streamed sut(numbered(100));
  for (ChunkIndex& chunk : sut.summary.chunks) chunk.start_ns = 2000 - chunk.start_ns;
  auto times = sut.times();
  EXPECT_EQ(times.size(), 100U);
  std::sort(times.begin(), times.end());
  EXPECT_EQ(std::unique(times.begin(), times.end()), times.end());
}

TEST(MessageStream, CountsChunksThatTheIndexPlacesOutsideOfTheFile) {
  Streamed sut(numbered(100));
  sut.summary.chunks[2].offset = ~std::uint64_t{0} - 4;
  sut.summary.chunks[3].length = ~std::uint64_t{0};
  sut.summary.chunks[4].length = 3;
  EXPECT_LT(sut.times().size(), 100U);
  EXPECT_EQ(sut.damage.chunks, 3U);
}

TEST(MessageStream, LeavesOutMessagesOfChannelsThatTheSummaryLacks) {
  Streamed sut(numbered(100));
  sut.summary.channels.erase(1);
  EXPECT_EQ(sut.times().size(), 50U);
}

TEST(MessageStream, GivesNothingWhenNoTopicIsWanted) {
  Streamed sut(numbered(100));
  Query query;
  query.wanted = [](const Channel&) { return false; };
  EXPECT_TRUE(sut.times(query).empty());
  EXPECT_TRUE(sut.source.offsets.empty());
}

TEST(MessageStream, TakesAMessageThatIsLargerThanAChunk) {
  Streamed sut({{"/a", 0, 1, std::string(100'000, 'x')}, {"/a", 1, 2, "y"}});
  EXPECT_EQ(sut.times(), (std::vector<std::uint64_t>{1, 2}));
}

}  // namespace
}  // namespace tocsin::mcap
