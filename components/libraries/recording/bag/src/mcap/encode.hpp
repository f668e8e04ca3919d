// SPDX-License-Identifier: Apache-2.0
// The bytes of records. Each function appends to `to`.
#pragma once

#include <cstdint>
#include <string>

#include "mcap/byte_sink.hpp"
#include "mcap/format.hpp"

namespace tocsin::mcap {

/// [byte] Opcode and length in front of each record's content.
inline constexpr std::size_t record_head = 9;
/// [byte] From the end of the file: footer and magic.
inline constexpr std::size_t footer_size = record_head + 20 + 8;

void put_number(Bytes& to, std::uint64_t value, std::size_t bytes);
void put_text(Bytes& to, const std::string& text);

/// Opcode and room for the length; returns where the content begins.
[[nodiscard]] std::size_t begin_record(Bytes& to, Opcode opcode);
/// Sets the length; `more` bytes of content follow from elsewhere.
void end_record(Bytes& to, std::size_t begin, std::uint64_t more = 0);

void put(Bytes& to, const Header& header);
void put(Bytes& to, const Schema& schema);
void put(Bytes& to, const Channel& channel);
void put(Bytes& to, const Message& message);
void put(Bytes& to, const Attachment& attachment, bool crc);
void put(Bytes& to, const Metadata& metadata);
void put(Bytes& to, const ChunkIndex& index);
void put(Bytes& to, const AttachmentIndex& index);
void put(Bytes& to, const MetadataIndex& index);
void put(Bytes& to, const Statistics& statistics);

/// CRC-32 of IEEE 802.3, of more bytes after those that gave `before`.
[[nodiscard]] std::uint32_t crc32(Span bytes, std::uint32_t before = 0);

}  // namespace tocsin::mcap
