// SPDX-License-Identifier: Apache-2.0
#include "mcap/recovery.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

struct Mended {
  Recovered recovered;
  Bytes bytes;
};

Mended mend(const Bytes& bytes) {
  MemorySource source(bytes);
  MemorySink sink;
  Mended mended;
  {
    Writer writer(sink, {});
    mended.recovered = recover(source, writer);
  }
  mended.bytes = sink.bytes();
  return mended;
}

TEST(Recovery, CopiesAWholeFileWithAllThatIsInIt) {
  MemorySink sink;
  const auto messages = numbered(50);
  {
    TwoTopics file(sink, small_chunks(Compression::zstd));
    (void)file.writer.write(Attachment{1, 2, "a", "b", "c"});
    for (const Sent& sent : messages) (void)file.write(sent);
    (void)file.writer.write(Metadata{"m", {{"x", "y"}}});
  }
  const Mended mended = mend(sink.bytes());
  EXPECT_EQ(mended.recovered.messages, 50U);
  EXPECT_EQ(mended.recovered.attachments, 1U);
  EXPECT_EQ(mended.recovered.metadata, 1U);
  EXPECT_EQ(mended.recovered.lost, 0U);
  EXPECT_FALSE(mended.recovered.damage.no_summary);
  Reader reader = reader_of(mended.bytes);
  EXPECT_EQ(all_of(reader), messages);
  EXPECT_EQ(reader.read(reader.summary().attachments.at(0))->data, "c");
  EXPECT_EQ(reader.read(reader.summary().metadata.at(0))->values.at("x"), "y");
  EXPECT_EQ(reader.summary().channels.at(1).metadata.at("k"), "v");
}

TEST(Recovery, KeepsWholeChunksAsTheyArePacked) {
  const Bytes bytes = file_of(numbered(50), small_chunks(Compression::zstd));
  const auto before = reader_of(bytes).summary().chunks;
  const auto after = reader_of(mend(bytes).bytes).summary().chunks;
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_EQ(after[i].compressed_size, before[i].compressed_size);
    EXPECT_EQ(after[i].compression, before[i].compression);
    EXPECT_EQ(after[i].start_ns, before[i].start_ns);
    EXPECT_EQ(after[i].end_ns, before[i].end_ns);
  }
}

TEST(Recovery, LeavesADamagedChunkOutAndCountsIt) {
  Bytes bytes = file_of(numbered(50), small_chunks());
  const auto chunks = reader_of(bytes).summary().chunks;
  bytes[chunks[1].offset + 60] ^= 1U;
  const Mended mended = mend(bytes);
  EXPECT_EQ(mended.recovered.damage.chunks, 1U);
  EXPECT_EQ(reader_of(mended.bytes).summary().chunks.size(), chunks.size() - 1);
}

TEST(Recovery, CountsMessagesWhoseChannelIsLost) {
  MemorySink sink;
  Bytes bytes;
  {
    TwoTopics file(sink);
    (void)file.write({"/a", 0, 1, "x"});
  }
  bytes = sink.bytes();
  const std::string topic = "/a";
  // The channel's opcode, 19 bytes before its topic, becomes one that nobody knows.
  const auto found = std::search(bytes.begin(), bytes.end(), topic.begin(), topic.end());
  *(found - 17) = 0x80;
  const Mended mended = mend(bytes);
  EXPECT_EQ(mended.recovered.messages, 0U);
  EXPECT_EQ(mended.recovered.damage.messages, 1U);
}

TEST(Recovery, KeepsMessagesWhoseSchemaIsLost) {
  Bytes bytes = file_of({{"/a", 0, 1, "x"}});
  const std::string name = "p/msg/T";
  const auto found = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  *(found - 15) = 0x80;  // opcode of the schema
  Reader reader = reader_of(mend(bytes).bytes);
  EXPECT_EQ(all_of(reader), (std::vector<Sent>{{"/a", 0, 1, "x"}}));
  EXPECT_EQ(reader.summary().channels.at(1).schema_id, 0U);
}

TEST(Recovery, TellsTheHeaderOfAFile) {
  MemorySource source(file_of({}, small_chunks()));
  EXPECT_EQ(header_of(source, "test").profile, "ros2");
  MemorySource wrong({1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_THROW((void)header_of(wrong, "test"), ConfigError);
}

}  // namespace
}  // namespace tocsin::mcap
