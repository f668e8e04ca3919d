// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "idl_support/type_info.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// The key hash of a message (RTPS 2.2, section 9.6.3.3): its key fields in big endian, or their
/// MD5 when they may take more than 16 bytes, or `as_md5`. False: the type has no key.
[[nodiscard]] bool key_hash(const TypeInfo& type, const void* message, bool as_md5,
                            eprosima::fastdds::rtps::InstanceHandle_t& hash);

/// The number by which samples name an instance. Never 0.
[[nodiscard]] std::uint64_t instance_of(const eprosima::fastdds::rtps::InstanceHandle_t& hash);
/// The same of a message; 0: the type has no key.
[[nodiscard]] std::uint64_t instance_of(const TypeInfo& type, const void* message);

}  // namespace tocsin
