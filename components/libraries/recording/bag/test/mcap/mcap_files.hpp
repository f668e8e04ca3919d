// SPDX-License-Identifier: Apache-2.0
// Files in memory for the tests, and what a reader gives of them.
#pragma once

#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "mcap/reader.hpp"
#include "mcap/writer.hpp"

namespace tocsin::mcap {

/// A message with bytes of its own.
struct Sent {
  std::string topic;
  std::uint32_t sequence;
  std::uint64_t log_time_ns;
  std::string data;
  friend bool operator==(const Sent& a, const Sent& b) {
    return std::tie(a.topic, a.sequence, a.log_time_ns, a.data) ==
           std::tie(b.topic, b.sequence, b.log_time_ns, b.data);
  }
};

inline void PrintTo(const Sent& sent, std::ostream* to) {
  *to << sent.topic << " " << sent.sequence << " at " << sent.log_time_ns << ", "
      << sent.data.size() << " bytes";
}

inline Message message_of(std::uint16_t channel, const Sent& sent) {
  return {channel,
          sent.sequence,
          sent.log_time_ns,
          sent.log_time_ns + 1,
          reinterpret_cast<const std::uint8_t*>(sent.data.data()),
          sent.data.size()};
}

/// A writer of two channels, /a and /b, of one schema.
class TwoTopics {
 public:
  explicit TwoTopics(ByteSink& sink, const WriterOptions& options = {})
      : writer(sink, options),
        schema(*writer.declare(Schema{0, "p/msg/T", "ros2msg", "int32 x\n"})),
        a(*writer.declare(Channel{0, schema, "/a", "cdr", {{"k", "v"}}})),
        b(*writer.declare(Channel{0, schema, "/b", "cdr", {}})) {}

  Kept write(const Sent& sent) {
    return writer.write(message_of(sent.topic == "/a" ? a : b, sent));
  }

  Writer writer;
  std::uint16_t schema;
  std::uint16_t a;
  std::uint16_t b;
};

inline Bytes file_of(const std::vector<Sent>& messages, const WriterOptions& options = {}) {
  MemorySink sink;
  {
    TwoTopics file(sink, options);
    for (const Sent& sent : messages) (void)file.write(sent);
  }
  return sink.bytes();
}

/// `count` messages with times 1000, 1001, ..., alternately of both topics.
inline std::vector<Sent> numbered(std::uint32_t count) {
  std::vector<Sent> messages;
  for (std::uint32_t i = 0; i < count; ++i) {
    messages.push_back({i % 2 == 0 ? "/a" : "/b", i, 1000 + i, "message " + std::to_string(i)});
  }
  return messages;
}

inline Reader reader_of(Bytes bytes) {
  return {std::make_unique<MemorySource>(std::move(bytes)), "test.mcap"};
}

inline std::vector<Sent> all_of(Reader& reader, const Query& query = {}) {
  std::vector<Sent> messages;
  const auto stream = reader.messages(query);
  while (const auto message = stream->next()) {
    messages.push_back({reader.summary().channels.at(message->channel_id).topic, message->sequence,
                        message->log_time_ns,
                        std::string(reinterpret_cast<const char*>(message->data), message->size)});
  }
  return messages;
}

inline std::vector<Sent> messages_in(const Bytes& bytes) {
  Reader reader = reader_of(bytes);
  return all_of(reader);
}

/// Several chunks of it are small.
inline WriterOptions small_chunks(Compression compression = Compression::none) {
  WriterOptions options;
  options.profile = "ros2";
  options.compression = compression;
  options.chunk_bytes = 200;
  return options;
}

}  // namespace tocsin::mcap
