// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// An encoded message, encapsulation header included, of a type that nobody here knows.
struct EncodedMessage {
  std::vector<std::uint8_t> bytes;
};

/// A type of this wire name whose messages are EncodedMessage: whatever comes is taken as it is.
/// One object for each name, for good. Any thread.
[[nodiscard]] const TypeInfo& raw_type(const std::string& name);

}  // namespace tocsin
