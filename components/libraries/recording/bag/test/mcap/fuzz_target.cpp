// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "foundation/error.hpp"
#include "mcap/recovery.hpp"
#include "mcap/tail.hpp"

namespace tocsin::mcap {
namespace {

std::uint64_t count_messages(Reader& reader, Order order) {
  Query query;
  query.order = order;
  const auto stream = reader.messages(query);
  std::uint64_t count = 0;
  std::uint64_t last = 0;
  std::uint64_t sum = 0;
  while (const auto message = stream->next()) {
    assert(order == Order::file || message->log_time_ns >= last ||
           !reader.damage().no_summary);  // an index may lie about times
    last = message->log_time_ns;
    for (std::size_t i = 0; i < message->size; ++i) sum += message->data[i];
    ++count;
  }
  return sum == ~std::uint64_t{0} ? 0 : count;  // the bytes are read in any case
}

/// Count of the messages, and sum of their last bytes, that a Tail reads of a file that grows in
/// steps of this size.
std::pair<std::uint64_t, std::uint64_t> follow(const Bytes& bytes, std::size_t step) {
  Tail tail("input");
  std::uint64_t count = 0;
  std::uint64_t sum = 0;
  const auto on_message = [&](const Channel&, const Message& message) {
    ++count;
    if (message.size > 0) sum += message.data[message.size - 1];
  };
  for (std::size_t size = step; size < bytes.size() + step; size += step) {
    const auto end = static_cast<std::ptrdiff_t>(std::min(size, bytes.size()));
    MemorySource source(Bytes(bytes.begin(), bytes.begin() + end));
    while (tail.read(source, on_message) == Tail::Step::read) {
    }
  }
  return {count, sum};
}

void use(const Bytes& bytes) {
  const auto at_once = follow(bytes, bytes.size() + 1);
  assert(at_once == follow(bytes, 500));
  Reader reader(std::make_unique<MemorySource>(bytes), "input");
  const std::uint64_t by_time = count_messages(reader, Order::log_time);
  assert(by_time == count_messages(reader, Order::file));
  for (const auto& index : reader.summary().attachments) (void)reader.read(index);
  for (const auto& index : reader.summary().metadata) (void)reader.read(index);

  MemorySource source(bytes);
  MemorySink sink;
  WriterOptions options;
  options.profile = header_of(source, "input").profile;
  Writer writer(sink, options);
  const Recovered recovered = recover(source, writer);
  (void)writer.close();
  Reader mended(std::make_unique<MemorySource>(sink.bytes()), "mended");
  assert(!mended.damage().no_summary);
  assert(mended.summary().statistics.message_count == recovered.messages);
  assert(count_messages(mended, Order::log_time) == recovered.messages);
}

}  // namespace
}  // namespace tocsin::mcap

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    tocsin::mcap::use(tocsin::mcap::Bytes(data, data + size));
  } catch (const tocsin::ConfigError&) {
    // No MCAP file.
  }
  return 0;
}
