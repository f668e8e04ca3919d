// SPDX-License-Identifier: Apache-2.0
#include "rtps/origin.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "foundation/hash.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

constexpr std::array<rtps::octet, 4> mark{'t', 'c', 's', 'n'};
constexpr std::size_t source_bytes = 8;

rtps::EntityId_t entity_of(const SamplePiece& piece, const SampleCoding& coding) {
  rtps::EntityId_t entity(0x00000003);  // a writer without key, RTPS 2.2 section 9.3.1.2
  if (coding.is_compressed) entity.value[2] = static_cast<rtps::octet>(coding.base + 1);
  if (piece.is_whole()) return entity;
  entity.value[0] = piece.index;
  entity.value[1] = piece.count;
  return entity;
}

SampleCoding coding_in(const rtps::EntityId_t& entity) {
  const rtps::octet byte = entity.value[2];
  return byte == 0 ? SampleCoding{} : SampleCoding{true, static_cast<std::uint8_t>(byte - 1)};
}

std::optional<SamplePiece> piece_in(const rtps::EntityId_t& entity) {
  const SamplePiece piece{entity.value[0], std::max<std::uint8_t>(entity.value[1], 1)};
  if (piece.index >= piece.count || piece.count > SamplePiece::most) return std::nullopt;
  return piece;
}

}  // namespace

std::uint64_t source_of(const rtps::GUID_t& guid) {
  std::string bytes(guid.guidPrefix.value, guid.guidPrefix.value + guid.guidPrefix.size);
  bytes.append(guid.entityId.value, guid.entityId.value + guid.entityId.size);
  return hash_of(bytes);
}

std::uint32_t wire_id_of(const rtps::EntityId_t& entity) {
  std::uint32_t id = 0;
  for (const rtps::octet byte : entity.value) id = id << 8U | byte;
  return id;
}

rtps::SampleIdentity identity_of(const Origin& origin) {
  rtps::GUID_t guid;
  for (std::size_t i = 0; i < source_bytes; ++i) {
    guid.guidPrefix.value[i] = static_cast<rtps::octet>(origin.source >> (8 * i));
  }
  std::copy(mark.begin(), mark.end(), guid.guidPrefix.value + source_bytes);
  guid.entityId = entity_of(origin.piece, origin.coding);
  rtps::SampleIdentity identity;
  identity.writer_guid(guid);
  identity.sequence_number(rtps::SequenceNumber_t(static_cast<std::int32_t>(origin.sequence >> 32U),
                                                  static_cast<std::uint32_t>(origin.sequence)));
  return identity;
}

std::optional<Origin> origin_in(const rtps::SampleIdentity& identity) {
  const rtps::octet* const bytes = identity.writer_guid().guidPrefix.value;
  if (!std::equal(mark.begin(), mark.end(), bytes + source_bytes)) return std::nullopt;
  const auto piece = piece_in(identity.writer_guid().entityId);
  if (!piece) return std::nullopt;
  Origin origin;
  origin.piece = *piece;
  origin.coding = coding_in(identity.writer_guid().entityId);
  for (std::size_t i = 0; i < source_bytes; ++i) {
    origin.source |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
  }
  origin.sequence = identity.sequence_number().to64long();
  return origin;
}

rtps::WriteParams on_behalf_of(const Origin& origin, std::int64_t sent_wall_ns) {
  rtps::WriteParams params;
  params.related_sample_identity(identity_of(origin));
  params.source_timestamp().from_ns(sent_wall_ns);
  return params;
}

}  // namespace tocsin
