// SPDX-License-Identifier: Apache-2.0
// Whatever is written is read again, whole, by summary and by walk.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

std::uint64_t seed() {
  const char* const given = std::getenv("TOCSIN_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

struct Drawn {
  WriterOptions options;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<std::pair<std::uint16_t, Sent>> messages;
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  std::uint64_t number(std::uint64_t most) {
    return std::uniform_int_distribution<std::uint64_t>(0, most)(random_);
  }
  std::string text(std::size_t longest) {
    std::string text(number(longest), ' ');
    const bool packable = number(1) == 0;
    for (char& c : text) c = static_cast<char>(number(packable ? 3 : 255));
    return text;
  }
  Drawn file() {
    Drawn drawn;
    drawn.options.profile = text(10);
    drawn.options.compression = static_cast<Compression>(number(2));
    drawn.options.chunk_bytes = 1 + number(5000);
    drawn.options.crc = number(3) != 0;
    for (std::size_t i = 0; i <= number(3); ++i) {
      drawn.schemas.push_back({0, text(20), text(8), text(300)});
    }
    for (std::uint64_t i = number(5) + 1; i > 0; --i) {
      const auto schema = static_cast<std::uint16_t>(number(drawn.schemas.size()));
      drawn.channels.push_back({0, schema, "/" + std::to_string(i), text(5), {{text(5), text(9)}}});
    }
    const bool in_order = number(1) == 0;
    for (std::uint64_t i = number(200); i > 0; --i) {
      const auto channel = static_cast<std::uint16_t>(1 + number(drawn.channels.size() - 1));
      const std::uint64_t time = in_order ? 500 - i : number(~std::uint64_t{0} - 1);
      drawn.messages.push_back(
          {channel,
           {drawn.channels[channel - 1U].topic, static_cast<std::uint32_t>(number(0xffffffff)),
            time, text(number(20) == 0 ? 9000 : 60)}});
    }
    return drawn;
  }

 private:
  std::mt19937_64 random_;
};

Bytes written(const Drawn& drawn) {
  MemorySink sink;
  Writer writer(sink, drawn.options);
  for (const Schema& schema : drawn.schemas) EXPECT_TRUE(writer.declare(schema));
  for (const Channel& channel : drawn.channels) EXPECT_TRUE(writer.declare(channel));
  for (const auto& [channel, sent] : drawn.messages) {
    EXPECT_EQ(writer.write(message_of(channel, sent)), Kept::all);
  }
  EXPECT_EQ(writer.close(), Kept::all);
  return sink.bytes();
}

TEST(RoundTrip, EveryFileIsReadAsItWasWritten) {
  const std::uint64_t first = seed();
  std::printf("TOCSIN_TEST_SEED=%llu\n", static_cast<unsigned long long>(first));
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Drawn drawn = Draw(first + i).file();
    const Bytes bytes = written(drawn);
    std::vector<Sent> in_file;
    for (const auto& [channel, sent] : drawn.messages) in_file.push_back(sent);
    auto by_time = in_file;
    std::stable_sort(by_time.begin(), by_time.end(),
                     [](const Sent& a, const Sent& b) { return a.log_time_ns < b.log_time_ns; });
    for (const std::size_t cut : {0U, 1U}) {
      Reader reader = reader_of(Bytes(bytes.begin(), bytes.end() - static_cast<long>(cut)));
      ASSERT_EQ(reader.damage().no_summary, cut > 0) << first + i;
      ASSERT_EQ(all_of(reader), by_time) << first + i;
      Query query;
      query.order = Order::file;
      ASSERT_EQ(all_of(reader, query), in_file) << first + i;
      ASSERT_EQ(reader.summary().statistics.message_count, in_file.size());
      ASSERT_EQ(reader.summary().channels.size(), drawn.channels.size());
      for (const auto& [id, channel] : reader.summary().channels) {
        ASSERT_EQ(channel.metadata, drawn.channels[id - 1U].metadata);
        ASSERT_EQ(channel.schema_id, drawn.channels[id - 1U].schema_id);
      }
      for (const auto& [id, schema] : reader.summary().schemas) {
        ASSERT_EQ(schema.data, drawn.schemas[id - 1U].data);
      }
    }
  }
}

}  // namespace
}  // namespace tocsin::mcap
