// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin::interop {

using Random = std::minstd_rand;

/// A type as both generators made it from the same IDL.
struct MessageType {
  const TypeInfo* ours;
  const dds_topic_descriptor_t* cyclone;
  std::shared_ptr<void> (*make)(Random& random);  ///< a message with drawn values
};

/// Every struct of the IDL files of the workspace.
[[nodiscard]] const std::vector<MessageType>& all_types();

}  // namespace tocsin::interop
