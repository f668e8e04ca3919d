// SPDX-License-Identifier: Apache-2.0
// A small file of ours, byte by byte as the specification says (https://mcap.dev/spec).
#include <gtest/gtest.h>

#include "encode.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

/// Bytes from hexadecimal text; white space counts nothing.
std::string bytes_of(const std::string& hex) {
  std::string bytes;
  std::string pair;
  for (const char c : hex) {
    if (c == ' ' || c == '\n') continue;
    pair += c;
    if (pair.size() < 2) continue;
    bytes += static_cast<char>(std::stoi(pair, nullptr, 16));
    pair.clear();
  }
  return bytes;
}

std::string golden() {
  return "\x89"
         "MCAP0\r\n"
         // Header: profile, library.
         + bytes_of("01 1200000000000000 04000000") + "ros2" + bytes_of("06000000") +
         "tocsin"
         // Schema 1: name, encoding, data.
         + bytes_of("03 1700000000000000 0100 03000000") + "p/T" + bytes_of("01000000") + "e" +
         bytes_of("05000000") +
         "int x"
         // Channel 1 of schema 1: topic, encoding, metadata of 10 bytes.
         + bytes_of("04 1f00000000000000 0100 0100 02000000") + "/a" + bytes_of("03000000") +
         "cdr" + bytes_of("0a000000 01000000") + "k" + bytes_of("01000000") +
         "v"
         // Chunk: start, end, size, CRC-32, compression, size; in it a message: channel, sequence,
         // log time, publish time, bytes.
         + bytes_of(
               "06 4900000000000000 0500000000000000 0500000000000000 2100000000000000 a611aef9"
               "00000000 2100000000000000"
               "05 1800000000000000 0100 07000000 0500000000000000 0400000000000000") +
         "hi"
         // MessageIndex of channel 1: 16 bytes: log time, offset.
         + bytes_of("07 1600000000000000 0100 10000000 0500000000000000 0000000000000000")
         // DataEnd without a checksum.
         + bytes_of("0f 0400000000000000 00000000");
}

TEST(GoldenFile, DataSectionIsAsTheSpecificationSays) {
  MemorySink sink;
  WriterOptions options;
  options.profile = "ros2";
  Writer writer(sink, options);
  ASSERT_EQ(writer.declare(Schema{0, "p/T", "e", "int x"}), 1);
  ASSERT_EQ(writer.declare(Channel{0, 1, "/a", "cdr", {{"k", "v"}}}), 1);
  const std::string hi = "hi";
  (void)writer.write(Message{1, 7, 5, 4, reinterpret_cast<const std::uint8_t*>(hi.data()), 2});
  (void)writer.close();
  const std::string file(sink.bytes().begin(), sink.bytes().end());
  EXPECT_EQ(file.substr(0, golden().size()), golden());
}

}  // namespace
}  // namespace tocsin::mcap
