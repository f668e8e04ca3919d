// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/sample_coding.hpp"
#include "foundation/sample_piece.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Who wrote a sample that a router carries, and which of his it is. It travels as the sample's
/// related identity (PID_RELATED_SAMPLE_IDENTITY), which ROS 2 and others use for services only;
/// the name of this stack in the GUID tells ours from theirs. The entity id of the
/// GUID has the place of a piece and their number in its first two bytes, zeros for a whole sample;
/// its third is 0 for content as it was written, else 1 and the distance of its base.
struct Origin {
  std::uint64_t source = 0;
  std::uint64_t sequence = 0;
  SamplePiece piece{};  ///< of that sample
  SampleCoding coding{};
};

/// Source of what a DDS writer writes itself, see Sample: a hash of its GUID.
[[nodiscard]] std::uint64_t source_of(const eprosima::fastdds::rtps::GUID_t& writer);

/// An entity id as a number, its first byte the highest.
[[nodiscard]] std::uint32_t wire_id_of(const eprosima::fastdds::rtps::EntityId_t& entity);

[[nodiscard]] eprosima::fastdds::rtps::SampleIdentity identity_of(const Origin& origin);
/// Nothing when the identity is not one of `identity_of`.
[[nodiscard]] std::optional<Origin> origin_in(
    const eprosima::fastdds::rtps::SampleIdentity& identity);
/// For a write on behalf of `origin`, who wrote at `sent_wall_ns` [ns since the Unix epoch].
[[nodiscard]] eprosima::fastdds::rtps::WriteParams on_behalf_of(const Origin& origin,
                                                                std::int64_t sent_wall_ns);

}  // namespace tocsin
