// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "mcap/byte_sink.hpp"
#include "mcap/byte_source.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// Reads a file from its beginning while another process writes it: each message once, in the order
/// of the file, as soon as its chunk is whole. One thread.
class Tail {
 public:
  enum class Step : std::uint8_t {
    read,   ///< a record was read
    waits,  ///< nothing whole is left as yet
    ended   ///< the file was closed: nothing will come
  };
  /// The message's bytes are valid during the call.
  using OnMessage = std::function<void(const Channel&, const Message&)>;

  /// `name` of the file, for error texts.
  explicit Tail(std::string name) : name_(std::move(name)) {}

  /// Reads the next record: a chunk with all its messages, or one outside of chunks. `source` is
  /// the file as it is now; a later one is longer. A chunk that is damaged is left out and counted.
  /// Throws ConfigError when it is no MCAP file.
  [[nodiscard]] Step read(ByteSource& source, const OnMessage& on_message);

  /// Those that came so far.
  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
  [[nodiscard]] std::uint64_t damaged_chunks() const { return damaged_chunks_; }

 private:
  void visit_chunk(ByteSource& source, std::uint64_t length, const OnMessage& on_message);
  void visit(Opcode opcode, Span content, const OnMessage& on_message);

  const std::string name_;
  std::uint64_t offset_ = 0;  ///< [byte] of the next record; 0: not even the magic was read
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::uint64_t damaged_chunks_ = 0;
};

}  // namespace tocsin::mcap
