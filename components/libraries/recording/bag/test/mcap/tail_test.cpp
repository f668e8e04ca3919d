// SPDX-License-Identifier: Apache-2.0
#include "mcap/tail.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

/// A file that is given to a Tail as far as it was written.
class TailTest : public ::testing::TestWithParam<Compression> {
 protected:
  /// Reads all that is whole in the first bytes of the file.
  Tail::Step read(const Bytes& bytes, std::size_t size) {
    MemorySource source(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size)));
    Tail::Step step = Tail::Step::read;
    while (step == Tail::Step::read) {
      step = sut_.read(source, [this](const Channel& channel, const Message& message) {
        got_.push_back({channel.topic, message.sequence, message.log_time_ns,
                        std::string(reinterpret_cast<const char*>(message.data), message.size)});
      });
    }
    return step;
  }
  Tail sut_{"test.mcap"};
  std::vector<Sent> got_;
};
INSTANTIATE_TEST_SUITE_P(Each, TailTest,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

TEST_P(TailTest, GivesEachMessageOnceAndInOrderHoweverTheFileGrows) {
  const auto messages = numbered(40);
  const Bytes bytes = file_of(messages, small_chunks(GetParam()));
  for (std::size_t size = 0; size <= bytes.size(); ++size) (void)read(bytes, size);
  EXPECT_EQ(got_, messages);
}

TEST_P(TailTest, GivesAChunkWhenItIsWholeAndNotBefore) {
  const auto messages = numbered(40);
  const Bytes bytes = file_of(messages, small_chunks(GetParam()));
  const Reader whole = reader_of(bytes);
  const ChunkIndex& first = whole.summary().chunks.at(0);
  const auto end = static_cast<std::size_t>(first.offset + first.length);
  EXPECT_EQ(read(bytes, end - 1), Tail::Step::waits);
  EXPECT_TRUE(got_.empty());
  EXPECT_EQ(read(bytes, end), Tail::Step::waits);
  EXPECT_FALSE(got_.empty());
}

TEST_P(TailTest, EndsWithAFileThatWasClosed) {
  const Bytes bytes = file_of(numbered(4), small_chunks(GetParam()));
  EXPECT_EQ(read(bytes, bytes.size()), Tail::Step::ended);
  EXPECT_EQ(sut_.schemas().begin()->second.name, "p/msg/T");
}

TEST_P(TailTest, LeavesADamagedChunkOutAndGoesOn) {
  const auto messages = numbered(40);
  Bytes bytes = file_of(messages, small_chunks(GetParam()));
  const Reader whole = reader_of(bytes);
  const ChunkIndex& third = whole.summary().chunks.at(2);
  bytes[third.offset + third.length - 1] ^= 0xff;
  EXPECT_EQ(read(bytes, bytes.size()), Tail::Step::ended);
  EXPECT_EQ(sut_.damaged_chunks(), 1U);
  EXPECT_LT(got_.size(), messages.size());
  EXPECT_EQ(got_.front(), messages.front());
  EXPECT_EQ(got_.back(), messages.back());
}

TEST(TailOfZeros, WaitsAsBeforeTheyWereWritten) {
  Bytes bytes = file_of({});
  bytes.resize(8);
  bytes.resize(100, 0);
  Tail sut("test.mcap");
  MemorySource source(bytes);
  EXPECT_EQ(sut.read(source, {}), Tail::Step::waits);
}

TEST(TailOfAnotherFile, IsRefused) {
  Tail sut("test.txt");
  MemorySource source(Bytes(100, 'x'));
  EXPECT_THROW((void)sut.read(source, {}), ConfigError);
}

}  // namespace
}  // namespace tocsin::mcap
