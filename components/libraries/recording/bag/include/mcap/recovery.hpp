// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mcap/byte_source.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"

namespace tocsin::mcap {

/// What was saved of a file.
struct Recovered {
  std::uint64_t messages = 0;
  std::uint64_t attachments = 0;
  std::uint64_t metadata = 0;
  std::uint64_t lost = 0;  ///< messages that the new file had no room for
  Damage damage;
};

/// The header of a file, for the writer that takes what is saved. Throws ConfigError, with `name`,
/// when it is no MCAP file.
[[nodiscard]] Header header_of(ByteSource& source, const std::string& name);

/// Copies all that can be read of `source`, in one walk from its beginning to its end or to where
/// it was cut, without using its summary. Whole chunks are checked and copied as they are; of
/// others the messages are. Takes the memory of one chunk or attachment. Does not close `writer`.
[[nodiscard]] Recovered recover(ByteSource& source, Writer& writer);

}  // namespace tocsin::mcap
